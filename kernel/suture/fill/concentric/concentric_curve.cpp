#include "suture/fill/concentric/concentric_curve.h"

#include "suture/base/contract.h"

#include <algorithm>
#include <cmath>

namespace suture::concentric {
namespace {

/// As a share of the period: a stop so near to a parameter is at that parameter.
constexpr double kSameParameter = 1e-9;

}  // namespace

Stop ConcentricCurve::stop(int k) const {
    Stop stop = stops[static_cast<std::size_t>(k % count())];
    const double turns = period * (k / count());
    stop.from += turns;
    stop.to += turns;
    return stop;
}

namespace {

/// The last stop, cyclic, that begins at or before s, and s on that stop's turn.
std::pair<int, double> stop_before(const ConcentricCurve& curve, double s) {
    const double first = curve.stops.front().from;
    double on_turn = s - curve.period * std::floor((s - first) / curve.period);
    if (on_turn >= first + curve.period) {
        on_turn -= curve.period;
    }
    const auto after =
        std::upper_bound(curve.stops.begin(), curve.stops.end(), on_turn,
                         [](double value, const Stop& stop) { return value < stop.from; });
    const auto k = static_cast<int>(after - curve.stops.begin()) - 1;
    SUTURE_EXPECTS(k >= 0);
    return {k, on_turn};
}

}  // namespace

Eigen::Vector2d evaluate(const ConcentricCurve& curve, double s) {
    const auto [k, at] = stop_before(curve, s);
    const Stop here = curve.stop(k);
    const Stop next = curve.stop(k + 1);
    if (at <= here.to) {
        return curve.node(here);
    }
    const double f = (at - here.to) / (next.from - here.to);
    return (1.0 - f) * curve.node(here) + f * curve.node(next);
}

int insert_node(ConcentricCurve& curve, double s) {
    const auto [k, at] = stop_before(curve, s);
    const Stop here = curve.stop(k);
    const Stop next = curve.stop(k + 1);
    const double same = kSameParameter * curve.period;
    if (at <= here.to + same) {
        return here.node;
    }
    if (at >= next.from - same) {
        return next.node;
    }
    const double f = (at - here.to) / (next.from - here.to);
    const auto node = static_cast<int>(curve.nodes.size());
    curve.nodes.push_back((1.0 - f) * curve.node(here) + f * curve.node(next));
    std::vector<Stop> stops;
    for (int i = 0; i < curve.count(); ++i) {
        const Stop a = curve.stop(i);
        const Stop b = curve.stop(i + 1);
        stops.push_back(a);
        if (i == k) {
            stops.push_back({node, at, at});
        } else if (a.node == next.node && b.node == here.node) {
            const double back = a.to + (1.0 - f) * (b.from - a.to);
            stops.push_back({node, back, back});
        }
    }
    curve.stops = std::move(stops);
    return node;
}

std::vector<Course> courses(const ConcentricCurve& curve) {
    std::vector<Course> pieces;
    for (int k = 0; k < curve.count(); ++k) {
        const Stop here = curve.stop(k);
        const Stop next = curve.stop(k + 1);
        const bool alone = curve.count() == 1;
        const double rest = alone ? here.from + curve.period : here.to;
        if (rest > here.from) {
            pieces.push_back({here.from, rest, here.node, here.node});
        }
        if (!alone && next.from > here.to) {
            pieces.push_back({here.to, next.from, here.node, next.node});
        }
    }
    return pieces;
}

}  // namespace suture::concentric

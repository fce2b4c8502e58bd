#include "suture/fill/concentric/concentric_curve.h"

#include "suture/base/contract.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace suture::concentric {
namespace {

/// A stop so near to a parameter is at that parameter.
constexpr double kNearStop = 10.0 * kSameParameter;

}  // namespace

Stop ConcentricCurve::stop(int k) const {
    Stop stop = stops[static_cast<std::size_t>(k % count())];
    const double turns =
        period *
        static_cast<double>(k / count());  // NOLINT(bugprone-integer-division): whole turns
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
    // Rounding may put a whole number of turns just before the first stop.
    on_turn = std::max(on_turn, first);
    const auto after =
        std::upper_bound(curve.stops.begin(), curve.stops.end(), on_turn,
                         [](double value, const Stop& stop) { return value < stop.from; });
    const auto k = static_cast<int>(after - curve.stops.begin()) - 1;
    SUTURE_EXPECTS(k >= 0);
    return {k, on_turn};
}

}  // namespace

int used_nodes(const ConcentricCurve& curve) {
    std::set<int> used;
    for (const Stop& stop : curve.stops) {
        used.insert(stop.node);
    }
    return static_cast<int>(used.size());
}

/// A piecewise linear B-spline of the concentric polygon: Definitions 2 and 3.
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
    if (curve.count() == 1) {
        return curve.stops.front().node;  // c rests there all the time
    }
    const auto [k, at] = stop_before(curve, s);
    const Stop here = curve.stop(k);
    const Stop next = curve.stop(k + 1);
    // A stop that is there but for rounding is moved there: nothing is left between the two.
    if (at <= here.to + kNearStop) {
        Stop& there = curve.stops[static_cast<std::size_t>(k)];
        if (std::abs(at - there.to) < kNearStop) {
            there.from = there.from < there.to ? there.from : at;
            there.to = at;
        } else if (std::abs(at - there.from) < kNearStop) {
            there.from = at;
        }
        return here.node;
    }
    if (at >= next.from - kNearStop) {
        Stop& there = curve.stops[static_cast<std::size_t>((k + 1) % curve.count())];
        const double on_turn = at - (k + 1 == curve.count() ? curve.period : 0.0);
        there.to = there.from < there.to ? there.to : on_turn;
        there.from = on_turn;
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
            // Where c comes back much faster, the pieces must not get too short to be edges.
            const double length = b.from - a.to;
            const double shortest = std::min(2.0 * kSameParameter, 0.5 * length);
            const double back = a.to + std::clamp((1.0 - f) * length, shortest, length - shortest);
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

#include "suture/fill/concentric/stubs.h"

#include "suture/fill/concentric/certificate.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

namespace suture::concentric {
namespace {

/// How far a stub goes towards its corner, from long to short, as a share of the way.
constexpr std::array kLengths = {0.2, 0.05, 0.01};

/// How long c rests at a stub's end, as a share of the way back.
constexpr double kRest = 0.2;

/// As a share of the period: a corner nearer to a rest's ends than this is no corner inside of it.
constexpr double kInside = 1e-7;

/// The corners inside of a rest, on its turn.
std::vector<double> corners_inside(const Stop& rest, double period,
                                   const std::vector<double>& corners) {
    std::vector<double> inside;
    const double margin = kInside * period;
    for (const double corner : corners) {
        const double on_turn = corner + period * std::ceil((rest.from + margin - corner) / period);
        if (on_turn < rest.to - margin) {
            inside.push_back(on_turn);
        }
    }
    std::sort(inside.begin(), inside.end());
    return inside;
}

class Growing {
  public:
    Growing(const ConcentricCurve& curve, const BoundaryPieces& boundary)
        : grown_(curve), boundary_(boundary) {
        grown_.stops.clear();
    }

    /// c rests from the start of `rest` to its end, and goes out to each corner on the way.
    void add(const Stop& rest, const std::vector<double>& corners) {
        double at = rest.from;
        for (std::size_t k = 0; k < corners.size(); ++k) {
            const double corner = corners[k];
            const double back = k + 1 < corners.size() ? 0.5 * (corner + corners[k + 1]) : rest.to;
            const double left = corner + kRest * (back - corner);
            const int end = branch_to(rest.node, at, {0, corner, left}, back);
            if (end >= 0) {
                add_stop({rest.node, start_, at});
                add_stop({end, corner, left});
                start_ = back;
            }
            at = back;
        }
        add_stop({rest.node, start_, rest.to});
    }

    void begin(double from) { start_ = from; }
    [[nodiscard]] ConcentricCurve take() { return std::move(grown_); }

  private:
    ConcentricCurve grown_;
    const BoundaryPieces& boundary_;
    double start_ = 0.0;  ///< where the rest that is being written begins

    void add_stop(const Stop& stop) { grown_.stops.push_back(stop); }

    /// The number of a new node towards a corner, or -1.
    int branch_to(int root, double from, const Stop& tip, double to) {
        const Eigen::Vector2d start = grown_.nodes[static_cast<std::size_t>(root)];
        const Eigen::Vector2d way = boundary_.at(tip.from) - start;
        const auto end = static_cast<int>(grown_.nodes.size());
        for (const double length : kLengths) {
            grown_.nodes.emplace_back(start + length * way);
            const auto positive = [&](const Course& course) {
                return certify(boundary_, grown_, course) == Certificate::Positive;
            };
            if (positive({from, tip.from, root, end}) && positive({tip.from, tip.to, end, end}) &&
                positive({tip.to, to, end, root})) {
                return end;
            }
            grown_.nodes.pop_back();
        }
        return -1;
    }
};

/// c rests all the time: a rest of one period that begins halfway between two corners.
Stop whole_rest(const ConcentricCurve& curve, const std::vector<double>& corners) {
    Stop rest = curve.stops.front();
    if (!corners.empty()) {
        rest.from = 0.5 * (corners.front() + corners.back() - curve.period);
    }
    rest.to = rest.from + curve.period;
    return rest;
}

/// Stubs wherever c rests over a corner.
ConcentricCurve with_stubs_at_rests(const ConcentricCurve& curve, const BoundaryPieces& boundary,
                                    const std::vector<double>& corners) {
    Growing growing(curve, boundary);
    const bool alone = curve.count() == 1;
    for (int k = 0; k < curve.count(); ++k) {
        const Stop rest = alone ? whole_rest(curve, corners) : curve.stop(k);
        growing.begin(rest.from);
        growing.add(rest, corners_inside(rest, curve.period, corners));
    }
    ConcentricCurve grown = growing.take();
    if (alone && grown.count() == 1) {
        return curve;
    }
    if (alone) {
        grown.stops.pop_back();  // the first one, a period later
    }
    return grown;
}

/// The stop where c is at s, and s on that stop's turn; -1: between two stops.
std::pair<int, double> stop_at(const ConcentricCurve& curve, double s) {
    const double margin = kInside * curve.period;
    for (int k = 0; k < curve.count(); ++k) {
        const Stop stop = curve.stop(k);
        const double on_turn =
            s + curve.period * std::ceil((stop.from - margin - s) / curve.period);
        if (on_turn <= stop.to + margin) {
            return {k, on_turn};
        }
    }
    return {-1, s};
}

/// From where a stop's neighbours are left and reached: before it, and after it.
std::pair<double, double> room_about(const ConcentricCurve& curve, int k) {
    const Stop here = curve.stop(k);
    return {here.from - (curve.stop(k + curve.count() - 1).to - curve.period),
            curve.stop(k + 1).from - here.to};
}

/// Whether c is at an end of the axis, a node with one edge.
bool at_end(const ConcentricCurve& curve, double s) {
    const int k = stop_at(curve, s).first;
    return k >= 0 && curve.stop(k + 1).node == curve.stop(k + curve.count() - 1).node;
}

/// A stub where c does not rest; `curve` itself where it would make the map fold.
ConcentricCurve with_stub_at(const ConcentricCurve& curve, const BoundaryPieces& boundary,
                             double s) {
    ConcentricCurve grown = curve;
    const int root = insert_node(grown, s);
    const auto [k, at] = stop_at(grown, s);
    if (k < 0 || grown.count() == 1) {
        return curve;
    }
    const Stop here = grown.stop(k);
    const auto [before, after] = room_about(grown, k);
    const Eigen::Vector2d way = boundary.at(s) - grown.node(here);
    for (const double length : kLengths) {
        const double reach = length * std::min(before, after);
        ConcentricCurve tried = grown;
        tried.nodes.emplace_back(grown.node(here) + length * way);
        const auto end = static_cast<int>(grown.nodes.size());
        const auto place = tried.stops.begin() + k;
        *place = {root, std::min(here.from, at - reach), at - reach};
        tried.stops.insert(place + 1, {{end, at, at + kRest * reach},
                                       {root, at + reach, std::max(here.to, at + reach)}});
        if (folded_courses(boundary, tried).empty()) {
            return tried;
        }
    }
    return curve;
}

/// The room that c leaves about its place at s, in the boundary's parameter.
double room_at(const ConcentricCurve& curve, double s) {
    ConcentricCurve with_node = curve;
    insert_node(with_node, s);
    const int k = stop_at(with_node, s).first;
    if (k < 0) {
        return 0.0;
    }
    const auto [before, after] = room_about(with_node, k);
    return std::min(before, after);
}

}  // namespace

Opened with_stubs(const ConcentricCurve& curve, const ClosedSpline& boundary, int sides) {
    const BoundaryPieces pieces(boundary);
    const ConcentricCurve grown = with_stubs_at_rests(curve, pieces, corner_parameters(boundary));
    int roomiest = 0;
    for (int side = 0; side < sides; ++side) {
        if (at_end(grown, side)) {
            return {grown, side};
        }
        if (room_at(grown, side) > room_at(grown, roomiest)) {
            roomiest = side;
        }
    }
    return {with_stub_at(grown, pieces, roomiest), roomiest};
}

}  // namespace suture::concentric

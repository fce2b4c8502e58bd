#include "suture/fill/extend/trimmed.h"

#include "suture/base/tolerance.h"
#include "suture/fill/extend/cut.h"
#include "suture/fill/extend/region.h"
#include "suture/fill/extend/sphere_frame.h"
#include "suture/fill/extend/trace.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <memory>
#include <optional>

namespace suture::extend {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

/// Turns a closed form about its axis so that what was u is u - angle.
void turn(Surface& surface, double angle) {
    std::visit(
        [&](auto& form) {
            using T = std::decay_t<decltype(form)>;
            if constexpr (!std::is_same_v<T, SplineSurface> && !std::is_same_v<T, Plane>) {
                Frame& frame = form.frame;
                const Vector3d x = std::cos(angle) * frame.x + std::sin(angle) * frame.y;
                frame.x = x.normalized();
                frame.y = frame.z.cross(frame.x);
            }
        },
        surface);
}

/// The traces' bounds.
struct Box {
    Vector2d low = Vector2d::Constant(INFINITY);
    Vector2d high = Vector2d::Constant(-INFINITY);
};

Box bounds_of(const std::vector<Trace>& traces) {
    Box box;
    for (const Trace& trace : traces) {
        box.low = box.low.cwiseMin(trace.low());
        box.high = box.high.cwiseMax(trace.high());
    }
    return box;
}

void shift_all(const Vector2d& by, std::vector<Trace>& traces, std::optional<Seam>& seam) {
    for (Trace& trace : traces) {
        trace.shift(by);
    }
    if (seam) {
        seam->from += by;
        seam->to += by;
    }
}

/// As a share of the period: the hole's border may lie beside the surface's own by rounding.
constexpr double kRounding = 1e-9;

/// The B-spline on a domain that holds the hole: beyond its borders its outermost polynomials go
/// on; where it is closed and its seam runs through the hole, it is cut open elsewhere.
void make_room(SplineSurface& spline, const Vector2d& period, std::vector<Trace>& traces,
               std::optional<Seam>& seam) {
    Box box = bounds_of(traces);
    for (const int c : {0, 1}) {
        const auto domain = [&] {
            const auto& knots = c == 0 ? spline.knots_u : spline.knots_v;
            return std::pair(knots.front(), knots.back());
        };
        const auto [begin, end] = domain();
        const double slack = kRounding * period[c];
        if (!(period[c] > 0.0)) {
            continue;
        }
        if (!(seam && seam->period[c] != 0.0)) {
            const double turns = std::floor((box.low[c] - begin + slack) / period[c]);
            shift_all(-turns * period[c] * Vector2d::Unit(c), traces, seam);
            box.low[c] -= turns * period[c];
            box.high[c] -= turns * period[c];
            if (box.high[c] > end + slack) {
                // Less than one period of it, so that no point has two places.
                const double beside = 0.25 * (period[c] - (box.high[c] - box.low[c]));
                const double low = box.low[c] - beside;
                const double high = box.high[c] + beside;
                spline = c == 0
                             ? restricted(repeated_u(spline, 3, 1), low, high, -INFINITY, INFINITY)
                             : restricted(repeated_v(spline, 3, 1), -INFINITY, INFINITY, low, high);
            }
        }
        // Rounding must not make it longer than its period.
        box.low[c] = std::max(box.low[c], domain().first);
        box.high[c] = std::min(box.high[c], domain().second);
    }
    spline = extended(spline, box.low.x(), box.high.x(), box.low.y(), box.high.y());
}

/// The closed form turned about its axis so that its own seam lies on the cut, or else opposite to
/// the hole.
void make_room(Surface& form, std::vector<Trace>& traces, std::optional<Seam>& seam) {
    const Box box = bounds_of(traces);
    const bool around = seam && seam->period.x() != 0.0;
    const double angle = around ? std::min(seam->from.x(), seam->from.x() + seam->period.x())
                                : 0.5 * (box.low.x() + box.high.x()) - kPi;
    turn(form, angle);
    shift_all({-angle, 0.0}, traces, seam);
}

/// Islands into the period of the loop around them.
void gather(const Chart& chart, int outer, std::vector<Trace>& traces) {
    const Vector2d centre = traces[static_cast<std::size_t>(outer)].centre();
    for (Trace& trace : traces) {
        trace.shift(nearest(trace.centre(), centre, chart.period) - trace.centre());
    }
}

/// Puts a band's two loops, or its loop and the pole, into one wire along the seam.
void join_along(const Seam& seam, std::vector<std::vector<EdgeUse>>& wires) {
    const auto from_corner = [&](int loop, int corner) {
        std::vector<EdgeUse> wire = std::move(wires[static_cast<std::size_t>(loop)]);
        std::rotate(wire.begin(), wire.begin() + corner, wire.end());
        return wire;
    };
    const auto line = [](const Vector2d& a, const Vector2d& b) -> TrimCurve {
        return [=](double s) -> Vector2d { return a + s * (b - a); };
    };
    const bool to_pole = seam.other_loop < 0;
    std::vector<EdgeUse> wire = from_corner(seam.loop, seam.corner);
    wire.push_back({-1, 0, false, line(seam.from + seam.period, seam.to + seam.period), to_pole});
    if (!to_pole) {
        std::vector<EdgeUse> beyond = from_corner(seam.other_loop, seam.other_corner);
        std::move(beyond.begin(), beyond.end(), std::back_inserter(wire));
    }
    wire.push_back({-1, 0, true, line(seam.from, seam.to)});
    std::erase_if(wires, [](const auto& emptied) { return emptied.empty(); });
    wires.insert(wires.begin(), std::move(wire));
}

}  // namespace

Result<bool> reversed_on(const Surface& surface, const Locate& locate, const Hole& hole) {
    Chart chart = chart_of(surface, 0.0, hole.diameter);
    chart.locate = locate;
    int outward = 0;
    int inward = 0;
    for (const RibbonLoop& loop : hole.loops) {
        for (const Ribbon& ribbon : loop.ribbons) {
            const Vector2d uv = chart.uv(ribbon, 0.5);
            const SurfaceJet jet = evaluate(chart.surface, uv.x(), uv.y());
            ++(jet.u.cross(jet.v).dot(ribbon.at(0.5).normal) > 0.0 ? outward : inward);
        }
    }
    if (outward > 0 && inward > 0) {
        return fail(ErrorCode::Refused,
                    "{} of the {} sides have their neighbour oriented against the others'",
                    std::min(outward, inward), outward + inward);
    }
    return inward > 0;
}

Result<FillResult> trimmed(const Surface& surface, const Locate& locate, bool reversed,
                           const Hole& hole, double distance) {
    Chart chart = chart_of(surface, distance, hole.diameter);
    chart.locate = locate;
    if (auto* sphere = std::get_if<Sphere>(&chart.surface)) {
        sphere->frame = sphere_frame(*sphere, hole, reversed);
    }
    std::vector<Trace> traces;
    for (const RibbonLoop& loop : hole.loops) {
        traces.push_back(unwrap(chart, sample_loop(chart, loop), reversed));
    }
    const auto region = region_of(chart, traces, reversed);
    if (!region) {
        return tl::unexpected(region.error());
    }
    std::optional<Seam> seam;
    if (region->kind == Region::Kind::Disc) {
        gather(chart, region->outer, traces);
    } else {
        const auto cut = cut_open(chart, *region, traces, hole.tolerance);
        if (!cut) {
            return tl::unexpected(cut.error());
        }
        seam = *cut;
    }
    if (auto* spline = std::get_if<SplineSurface>(&chart.surface)) {
        make_room(*spline, chart.period, traces, seam);
    } else if (chart.period.x() > 0.0) {
        make_room(chart.surface, traces, seam);
    }
    Patch patch;
    patch.surface = chart.surface;
    patch.reversed = reversed;
    const auto shared = std::make_shared<const Chart>(std::move(chart));
    for (std::size_t l = 0; l < hole.loops.size(); ++l) {
        std::vector<TrimCurve> row;
        for (std::size_t i = 0; i < hole.loops[l].ribbons.size(); ++i) {
            row.push_back(trim_of(shared, hole.loops[l].ribbons[i], traces[l].sides[i]));
        }
        std::vector<EdgeUse>& wire =
            patch.wires.emplace_back(wire_of_loop(static_cast<int>(l), std::move(row)));
        for (const int corner : traces[l].pole_corners) {
            const std::size_t before = (static_cast<std::size_t>(corner) + wire.size() - 1);
            wire[before % wire.size()].pole_after = true;
        }
    }
    FillResult result;
    if (seam) {
        join_along(*seam, patch.wires);
        const bool to_pole = seam->other_loop < 0;
        result.inner_edges = {{{seam->loop, seam->corner},
                               to_pole ? Node{-1, 0} : Node{seam->other_loop, seam->other_corner}}};
        if (to_pole) {
            result.inner_vertices = {evaluate(patch.surface, seam->to.x(), seam->to.y()).point};
        }
    }
    result.patches.push_back(std::move(patch));
    return result;
}

}  // namespace suture::extend

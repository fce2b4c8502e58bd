#include "suture/fill/loft/spans.h"

#include "suture/base/tolerance.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace suture::loft {
namespace {

using Eigen::Vector3d;

/// Sides that turn by less, and whose neighbours differ by less, run on without a corner.
const double kCorner = radians(1.0);

/// Points of a rim to find which of the other rim's faces it.
constexpr int kPoints = 96;

bool is_curve(const Ribbon& ribbon) {
    return ribbon.face == 0;
}

LoftLeaving leaving_of(const RibbonPoint& point, const Vector3d& vector) {
    return {vector.dot(point.inward), vector.dot(point.tangent.normalized())};
}

Vector3d vector_of(const RibbonPoint& point, const LoftLeaving& leaving) {
    return leaving.inward * point.inward + leaving.along * point.tangent.normalized();
}

double angle(const Vector3d& a, const Vector3d& b) {
    return std::atan2(a.cross(b).norm(), a.dot(b));
}

/// Whether there is a corner where a side begins.
bool is_corner(const RibbonLoop& loop, std::size_t i) {
    const std::size_t n = loop.ribbons.size();
    const RibbonPoint before = loop.ribbons[(i + n - 1) % n].at(1.0);
    const RibbonPoint after = loop.ribbons[i].at(0.0);
    return angle(before.tangent, after.tangent) > kCorner ||
           angle(before.normal, after.normal) > kCorner;
}

/// The direction in which a surface leaves a corner of a rail, tangent to both neighbours.
Vector3d direction_at(const RibbonPoint& before, const RibbonPoint& after) {
    const Vector3d mean = before.inward + after.inward;
    if (angle(before.normal, after.normal) < kCorner) {
        return mean.normalized();
    }
    const Vector3d common = before.normal.cross(after.normal).normalized();
    return common.dot(mean) < 0.0 ? Vector3d(-common) : common;
}

/// The sides from one place of a loop to another, in its order; all of them if both are the same.
std::vector<std::size_t> sides_between(std::size_t first, std::size_t end, std::size_t count) {
    std::vector<std::size_t> sides;
    std::size_t i = first;
    do {
        sides.push_back(i);
        i = (i + 1) % count;
    } while (i != end);
    return sides;
}

std::vector<std::size_t> corners_of_loop(const RibbonLoop& loop) {
    std::vector<std::size_t> corners;
    for (std::size_t i = 0; i < loop.ribbons.size(); ++i) {
        if (is_corner(loop, i)) {
            corners.push_back(i);
        }
    }
    return corners;
}

/// Corner i of the first rim faces corner facing[i] of the second, whose loop goes the other way.
struct FacingCorners {
    std::vector<std::size_t> from, to;
};

Vector3d corner_point(const RibbonLoop& loop, std::size_t i) {
    return loop.ribbons[i].at(0.0).point;
}

/// Which corners face each other: those that are nearest, all together.
FacingCorners face_corners(const RibbonLoop& one, const RibbonLoop& other) {
    FacingCorners facing{corners_of_loop(one), {}};
    const std::vector<std::size_t> theirs = corners_of_loop(other);
    const std::size_t n = theirs.size();
    double least = INFINITY;
    for (std::size_t offset = 0; offset < n; ++offset) {
        std::vector<std::size_t> to;
        double apart = 0.0;
        for (std::size_t i = 0; i < n; ++i) {
            to.push_back(theirs[(offset + n - i) % n]);
            apart +=
                (corner_point(one, facing.from[i]) - corner_point(other, to.back())).squaredNorm();
        }
        if (apart < least) {
            least = apart;
            facing.to = std::move(to);
        }
    }
    return facing;
}

/// Whether a rim has no neighbours.
bool is_free(const RibbonLoop& loop) {
    return std::ranges::all_of(loop.ribbons, is_curve);
}

/// How a surface leaves two corners that face each other, as the sides after (or before) them see
/// it.
void leave_corners(const Vector3d& at_from, const Vector3d& at_to, const RibbonPoint& from,
                   const RibbonPoint& to, double tension, LoftEnd& end) {
    const double gap = tension * (to.point - from.point).norm();
    end.from = leaving_of(from, gap * at_from);
    end.to = leaving_of(to, gap * at_to);
}

/// By how much the second rail lags behind where it is nearest to the first.
double nearest_shift(const Rail& from, const Rail& to) {
    std::vector<Vector3d> ours;
    std::vector<Vector3d> theirs;
    for (int k = 0; k < kPoints; ++k) {
        ours.push_back(from.at(static_cast<double>(k) / kPoints).point);
        theirs.push_back(to.at(static_cast<double>(k) / kPoints).point);
    }
    std::vector<double> apart(kPoints, 0.0);
    for (int shift = 0; shift < kPoints; ++shift) {
        for (int k = 0; k < kPoints; ++k) {
            const auto facing = static_cast<std::size_t>((k + kPoints - shift) % kPoints);
            apart[static_cast<std::size_t>(shift)] +=
                (ours[static_cast<std::size_t>(k)] - theirs[facing]).squaredNorm();
        }
    }
    const int best = static_cast<int>(std::ranges::min_element(apart) - apart.begin());
    // Between the points: the lowest point of the parabola through three of them.
    const double a = apart[static_cast<std::size_t>((best + kPoints - 1) % kPoints)];
    const double b = apart[static_cast<std::size_t>(best)];
    const double c = apart[static_cast<std::size_t>((best + 1) % kPoints)];
    const double bend = a - 2.0 * b + c;
    const double part = bend > 0.0 ? 0.5 * (a - c) / bend : 0.0;
    const double shift = (best + part) / kPoints;
    return shift > 0.5 ? shift - 1.0 : shift;
}

Result<LoftLayout> lay_out_tube(const RibbonLoop& one, const RibbonLoop& other, double tension) {
    const FacingCorners facing = face_corners(one, other);
    const std::size_t corners = facing.from.size();
    if (corners != corners_of_loop(other).size()) {
        return fail(ErrorCode::Refused,
                    "the rims have {} and {} corners: no patch runs from corner to corner", corners,
                    corners_of_loop(other).size());
    }
    LoftLayout layout;
    if (corners == 0) {
        layout.inner_edges.push_back({{0, 0}, {1, 0}});
        Rail from(one, sides_between(0, 0, one.ribbons.size()), /*backwards=*/false);
        Rail to(other, sides_between(0, 0, other.ribbons.size()), /*backwards=*/true);
        const double shift = nearest_shift(from, to);
        LoftEnd seam;
        seam.edge = 0;
        layout.spans.push_back({std::move(from), std::move(to), seam, seam, shift, /*closed=*/true,
                                is_free(one), is_free(other), tension});
        return layout;
    }
    const auto before = [](const RibbonLoop& loop, std::size_t i) {
        return loop.ribbons[(i + loop.ribbons.size() - 1) % loop.ribbons.size()].at(1.0);
    };
    const auto after = [](const RibbonLoop& loop, std::size_t i) {
        return loop.ribbons[i].at(0.0);
    };
    for (std::size_t c = 0; c < corners; ++c) {
        const std::size_t a = facing.from[c];
        const std::size_t b = facing.to[c];
        layout.inner_edges.push_back({{0, static_cast<int>(a)}, {1, static_cast<int>(b)}});
        const std::size_t next = (c + 1) % corners;
        LoftSpan span{Rail(one, sides_between(a, facing.from[next], one.ribbons.size()), false),
                      Rail(other, sides_between(facing.to[next], b, other.ribbons.size()), true),
                      {},
                      {},
                      0.0,
                      false};
        span.begin.edge = static_cast<int>(c);
        span.end.edge = static_cast<int>(next);
        const auto leave = [&](std::size_t corner, bool first, LoftEnd& end) {
            const std::size_t i = facing.from[corner];
            const std::size_t j = facing.to[corner];
            leave_corners(direction_at(before(one, i), after(one, i)),
                          direction_at(before(other, j), after(other, j)),
                          first ? after(one, i) : before(one, i),
                          first ? before(other, j) : after(other, j), tension, end);
        };
        leave(c, /*first=*/true, span.begin);
        leave(next, /*first=*/false, span.end);
        span.free_from = is_free(one);
        span.free_to = is_free(other);
        layout.spans.push_back(std::move(span));
    }
    return layout;
}

Error no_bridge() {
    return {ErrorCode::Refused,
            "the hole is no bridge: it needs two closed rims, or two chains of sides and a curve "
            "without a face between each two ends of them"};
}

template <class Predicate>
std::vector<std::size_t> sides_where(const RibbonLoop& loop, Predicate&& holds) {
    std::vector<std::size_t> sides;
    for (std::size_t i = 0; i < loop.ribbons.size(); ++i) {
        if (holds(loop.ribbons[i])) {
            sides.push_back(i);
        }
    }
    return sides;
}

/// The corners inside a chain of sides.
std::vector<std::size_t> inner_corners(const RibbonLoop& loop,
                                       const std::vector<std::size_t>& chain) {
    std::vector<std::size_t> corners;
    for (std::size_t k = 1; k < chain.size(); ++k) {
        if (is_corner(loop, chain[k])) {
            corners.push_back(chain[k]);
        }
    }
    return corners;
}

/// The chain after a free curve, up to the other one.
std::vector<std::size_t> chain_after(std::size_t curve, std::size_t other, std::size_t count) {
    return sides_between((curve + 1) % count, other, count);
}

Result<LoftLayout> lay_out_bridge(const RibbonLoop& loop, double tension) {
    const std::size_t n = loop.ribbons.size();
    std::vector<std::size_t> curves = sides_where(loop, [](const Ribbon& side) {
        return is_curve(side) && side.edge == 0;  // those that were made to connect the others
    });
    if (curves.size() != 2) {
        curves = sides_where(loop, is_curve);
    }
    if (curves.size() != 2 || curves[1] == curves[0] + 1 || (curves[1] + 1) % n == curves[0]) {
        return tl::unexpected(no_bridge());
    }
    const auto [back, forth] = std::pair(curves[0], curves[1]);
    const std::vector<std::size_t> from = chain_after(back, forth, n);
    const std::vector<std::size_t> to = chain_after(forth, back, n);
    const std::vector<std::size_t> ours = inner_corners(loop, from);
    std::vector<std::size_t> theirs = inner_corners(loop, to);
    if (ours.size() != theirs.size()) {
        return fail(ErrorCode::Refused,
                    "the chains have {} and {} corners: no patch runs from corner to corner",
                    ours.size(), theirs.size());
    }
    std::ranges::reverse(theirs);
    LoftLayout layout;
    for (std::size_t c = 0; c < ours.size(); ++c) {
        layout.inner_edges.push_back(
            {{0, static_cast<int>(ours[c])}, {0, static_cast<int>(theirs[c])}});
    }
    const auto before = [&](std::size_t i) { return loop.ribbons[(i + n - 1) % n].at(1.0); };
    const auto after = [&](std::size_t i) { return loop.ribbons[i].at(0.0); };
    for (std::size_t k = 0; k <= ours.size(); ++k) {
        const bool first = k == 0;
        const bool last = k == ours.size();
        const std::size_t a0 = first ? from.front() : ours[k - 1];
        const std::size_t a1 = last ? forth : ours[k];
        const std::size_t b0 = last ? to.front() : theirs[k];
        const std::size_t b1 = first ? back : theirs[k - 1];
        LoftSpan span{Rail(loop, sides_between(a0, a1, n), false),
                      Rail(loop, sides_between(b0, b1, n), true),
                      {},
                      {},
                      0.0,
                      false};
        if (first) {
            span.begin.side = back;
            const Ribbon& curve = loop.ribbons[back];
            span.begin.from = leaving_of(after(a0), -curve.at(1.0).tangent);
            span.begin.to = leaving_of(before(b1), curve.at(0.0).tangent);
        } else {
            span.begin.edge = static_cast<int>(k) - 1;
            leave_corners(direction_at(before(a0), after(a0)), direction_at(before(b1), after(b1)),
                          after(a0), before(b1), tension, span.begin);
        }
        if (last) {
            span.end.side = forth;
            const Ribbon& curve = loop.ribbons[forth];
            span.end.from = leaving_of(before(a1), curve.at(0.0).tangent);
            span.end.to = leaving_of(after(b0), -curve.at(1.0).tangent);
        } else {
            span.end.edge = static_cast<int>(k);
            leave_corners(direction_at(before(a1), after(a1)), direction_at(before(b0), after(b0)),
                          before(a1), after(b0), tension, span.end);
        }
        layout.spans.push_back(std::move(span));
    }
    return layout;
}

}  // namespace

std::pair<double, double> LoftSpan::range() const {
    return {std::min(0.0, shift), 1.0 + std::max(0.0, shift)};
}

Eigen::VectorXd LoftSpan::column(double u) const {
    const RibbonPoint a = from.at(u);
    const RibbonPoint b = to.at(u - shift);
    const Vector3d chord = b.point - a.point;
    const auto between = [u](const LoftLeaving& one, const LoftLeaving& other) {
        return LoftLeaving{(1.0 - u) * one.inward + u * other.inward,
                           (1.0 - u) * one.along + u * other.along};
    };
    const auto leaving = [&](const RibbonPoint& point, const LoftLeaving& first,
                             const LoftLeaving& last) {
        return closed ? Vector3d(tension * chord.norm() * point.inward)
                      : vector_of(point, between(first, last));
    };
    // Without a neighbour there is nothing to be tangent to: straight across.
    const Vector3d leaves = free_from ? chord : leaving(a, begin.from, end.from);
    const Vector3d arrives = free_to ? Vector3d(-chord) : leaving(b, begin.to, end.to);
    Eigen::VectorXd rows(12);
    rows << a.point, a.point + leaves / 3.0, b.point + arrives / 3.0, b.point;
    return rows;
}

Result<LoftLayout> lay_out(const Hole& hole, double tension) {
    if (hole.loops.size() == 2) {
        return lay_out_tube(hole.loops[0], hole.loops[1], tension);
    }
    return hole.loops.size() == 1 ? lay_out_bridge(hole.loops[0], tension)
                                  : Result<LoftLayout>(tl::unexpected(no_bridge()));
}

}  // namespace suture::loft

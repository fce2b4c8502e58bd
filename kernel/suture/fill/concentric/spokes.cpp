#include "suture/fill/concentric/spokes.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace suture::concentric {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

/// Neighbours whose normals differ by more at a corner cannot both be met there.
constexpr double kSameNormal = radians(0.05);

/// The share of a side beside a corner over which what the corner wants dies out.
constexpr double kFade = 0.1;

/// Steps of differences, as a share of a strip's length.
constexpr double kStep = 1e-4;

double angle_between(const Vector3d& a, const Vector3d& b) {
    return std::atan2(a.cross(b).norm(), a.dot(b));
}

/// From 1 at 0 to 0 at 1 and beyond, with two derivatives that are 0 at both ends.
double fading(double x) {
    return x >= 1.0 ? 0.0 : 1.0 - x * x * x * (10.0 - 15.0 * x + 6.0 * x * x);
}

/// What a slope lacks to lie in the plane across a normal.
Vector3d into_plane(const Vector3d& slope, const Vector3d& normal) {
    return -normal.dot(slope) * normal;
}

Vector3d slope_of(const SurfaceJet& jet, const Vector2d& along) {
    return along.x() * jet.u + along.y() * jet.v;
}

}  // namespace

Spokes::Spokes(const Hole& hole, const Boundary& boundary, const Guide& guide,
               const ConcentricCurve& axis)
    : hole_(hole), boundary_(boundary), guide_(guide), axis_(axis) {
    const int n = boundary.count();
    for (int i = 0; i < n; ++i) {
        const Ribbon& before = ribbon((i + n - 1) % n);
        const Ribbon& after = ribbon(i);
        const Vector3d a = before.continuity >= Continuity::G1 ? before.at(1.0).normal
                                                               : Vector3d(Vector3d::Zero());
        const Vector3d b =
            after.continuity >= Continuity::G1 ? after.at(0.0).normal : Vector3d(Vector3d::Zero());
        const bool conflict = !a.isZero() && !b.isZero() && angle_between(a, b) > kSameNormal;
        const Vector2d from = guide.sides[static_cast<std::size_t>(i)](0.0);
        const Vector3d slope =
            slope_of(evaluate(guide.surface, from.x(), from.y()), evaluate(axis, i) - from);
        const Vector3d sum = a + b;
        corner_bends_.push_back(conflict || sum.isZero() ? Vector3d(Vector3d::Zero())
                                                         : into_plane(slope, sum.normalized()));
    }
}

/// In the neighbour's plane. Towards corners it becomes what both sides have there, and does not
/// change with s: else faces on both sides of the seam would part.
Vector3d Spokes::bend(int side, double s, const Vector2d& at, const Vector2d& along) const {
    double left = 1.0;
    Vector3d result = Vector3d::Zero();
    for (const int end : {0, 1}) {
        const double share = fading((end == 0 ? s : 1.0 - s) / kFade);
        left -= share;
        result += share * corner_bends_[static_cast<std::size_t>((side + end) % boundary_.count())];
    }
    if (left > 0.0 && ribbon(side).continuity >= Continuity::G1) {
        const Vector3d slope = slope_of(evaluate(guide_.surface, at.x(), at.y()), along);
        result += left * into_plane(slope, ribbon(side).at(s).normal);
    }
    return result;
}

Spoke Spokes::at(const Strip& strip, double s) const {
    const Course& course = strip.course;
    const Vector2d a = axis_.nodes[static_cast<std::size_t>(course.start)];
    const Vector2d b = axis_.nodes[static_cast<std::size_t>(course.end)];
    const double part = std::clamp((s - course.from) / (course.to - course.from), 0.0, 1.0);
    const int on_turn = strip.side % boundary_.count();
    const double own = std::clamp(s - strip.side, 0.0, 1.0);
    const auto k = static_cast<std::size_t>(on_turn);
    Spoke spoke;
    spoke.from = guide_.sides[k](own);
    spoke.along = a + part * (b - a) - spoke.from;
    const Vector3d wanted = evaluate(boundary_.sides[k], on_turn + own).col(0);
    spoke.missed = wanted - evaluate(guide_.surface, spoke.from.x(), spoke.from.y()).point;
    spoke.bend = bend(on_turn, own, spoke.from, spoke.along);
    return spoke;
}

MovingSpoke Spokes::moving(const Strip& strip, double s) const {
    // The slope of the parabola through three spokes.
    const double step = kStep * (strip.to - strip.from);
    const double middle = std::clamp(s, strip.from + step, strip.to - step);
    const Spoke before = at(strip, middle - step);
    const Spoke here = at(strip, middle);
    const Spoke after = at(strip, middle + step);
    const double off = (s - middle) / step;
    const double ahead = (0.5 + off) / step;
    const double back = (0.5 - off) / step;
    return {at(strip, s),
            {ahead * (after.from - here.from) + back * (here.from - before.from),
             ahead * (after.along - here.along) + back * (here.along - before.along),
             ahead * (after.missed - here.missed) + back * (here.missed - before.missed),
             ahead * (after.bend - here.bend) + back * (here.bend - before.bend)}};
}

Vector3d Spokes::point(const Spoke& spoke, double t) const {
    const Vector2d at = spoke.from + t * spoke.along;
    const double left = (1.0 - t) * (1.0 - t);
    return evaluate(guide_.surface, at.x(), at.y()).point + left * (1.0 + 2.0 * t) * spoke.missed +
           left * t * spoke.bend;
}

Vector3d Spokes::slope(const Spoke& spoke, double t) const {
    const Vector2d at = spoke.from + t * spoke.along;
    return slope_of(evaluate(guide_.surface, at.x(), at.y()), spoke.along) -
           6.0 * t * (1.0 - t) * spoke.missed + (1.0 - t) * (1.0 - 3.0 * t) * spoke.bend;
}

SpokeJet Spokes::jet(const MovingSpoke& spoke, double t) const {
    const auto& [here, change] = spoke;
    const Vector2d at = here.from + t * here.along;
    const Vector2d along_s = change.from + t * change.along;
    const SurfaceJet x = evaluate(guide_.surface, at.x(), at.y());
    const double left = (1.0 - t) * (1.0 - t);
    const double h0 = left * (1.0 + 2.0 * t);
    const double h1 = left * t;
    const double h0_t = -6.0 * t * (1.0 - t);
    const double h1_t = (1.0 - t) * (1.0 - 3.0 * t);
    const auto second = [&](const Vector2d& a, const Vector2d& b) -> Vector3d {
        return a.x() * b.x() * x.uu + (a.x() * b.y() + a.y() * b.x()) * x.uv + a.y() * b.y() * x.vv;
    };
    return {x.point + h0 * here.missed + h1 * here.bend,
            slope_of(x, along_s) + h0 * change.missed + h1 * change.bend,
            slope_of(x, here.along) + h0_t * here.missed + h1_t * here.bend,
            second(along_s, here.along) + slope_of(x, change.along) + h0_t * change.missed +
                h1_t * change.bend};
}

Vector3d Spokes::node(int node) const {
    const Vector2d at = axis_.nodes[static_cast<std::size_t>(node)];
    return evaluate(guide_.surface, at.x(), at.y()).point;
}

}  // namespace suture::concentric

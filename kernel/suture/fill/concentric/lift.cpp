#include "suture/fill/concentric/lift.h"

#include "suture/fill/concentric/sweep.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace suture::concentric {
namespace {

using Eigen::MatrixXd;
using Eigen::Vector2d;
using Eigen::Vector3d;
using Eigen::VectorXd;

/// Neighbours that lean more stand across the hole: their slopes are no gentle ones.
constexpr double kMostLean = radians(75.0);

/// Degree in s of what is fitted.
constexpr int kDegree = 5;

/// The most spans in t.
constexpr int kMostSpans = 32;

/// A fit is finer than the wanted angle by this factor.
constexpr double kFitShare = 0.02;

/// So are slopes along the axis, where both sides have the same anyway, by this factor.
constexpr double kAxisShare = 0.3;

/// Slopes that differ by more make a visible change where they fade.
constexpr double kConflict = 1e-4;

/// Spokes over each course to choose the number of spans in t by.
constexpr int kTrialSpokes = 8;

/// The gradient of the tangent plane with this normal, as a height over the frame's plane.
Vector2d gradient_of(const Frame& frame, const Vector3d& normal) {
    return Vector2d(-normal.dot(frame.x), -normal.dot(frame.y)) / normal.dot(frame.z);
}

/// From 1 at 0 to 0 at 1 and beyond, with two derivatives that are 0 at both ends.
double fading(double x) {
    return x >= 1.0 ? 0.0 : 1.0 - x * x * x * (10.0 - 15.0 * x + 6.0 * x * x);
}

const Ribbon& ribbon_of(const Hole& hole, int side) {
    return hole.loops.front().ribbons[static_cast<std::size_t>(side)];
}

}  // namespace

Lift::Lift(const Hole& hole, const Boundary& boundary, const ConcentricCurve& axis,
           HeightField field, const Tolerance& tolerance)
    : hole_(hole),
      boundary_(boundary),
      axis_(axis),
      field_(std::move(field)),
      accuracy_(kFitShare *
                std::min(tolerance.angular * field_.least_distance(axis), tolerance.linear)),
      lifted_axis_(axis, field_, accuracy_, kAxisShare * tolerance.angular) {
    for (int side = 0; side < boundary.count(); ++side) {
        sides_.push_back(local(boundary.sides[static_cast<std::size_t>(side)]));
        conflicts_.push_back(
            {missed_gradient(side, side).norm(), missed_gradient(side, side + 1.0).norm()});
    }
    choose_radial_spans();
    error_ = lifted_axis_.error();
}

Result<Lift> Lift::make(const Hole& hole, const Boundary& boundary, const ConcentricCurve& axis,
                        const Tolerance& tolerance) {
    constexpr int kProbes = 32;
    for (const Ribbon& ribbon : hole.loops.front().ribbons) {
        for (int k = 0; ribbon.continuity >= Continuity::G1 && k <= kProbes; ++k) {
            const Vector3d normal = ribbon.at(static_cast<double>(k) / kProbes).normal;
            const double lean = std::acos(std::clamp(normal.dot(boundary.frame.z), -1.0, 1.0));
            if (lean > kMostLean) {
                return fail(ErrorCode::Refused,
                            "the neighbour at {} leans by {:.1f} deg from the hole's mean plane "
                            "(limit {:.0f}): no surface over that plane is tangent to it",
                            name_of(ribbon), degrees(lean), degrees(kMostLean));
            }
        }
    }
    return Lift(hole, boundary, axis, HeightField::over(hole, boundary, tolerance), tolerance);
}

Vector3d Lift::vertex(int node) const {
    return boundary_.lifted(axis_.nodes[static_cast<std::size_t>(node)]) +
           lifted_axis_.height(node) * boundary_.frame.z;
}

/// What the height field's gradient misses of the neighbour's: nothing where position alone is
/// wanted.
Vector2d Lift::missed_gradient(int side, double s) const {
    const Ribbon& ribbon = ribbon_of(hole_, side);
    if (ribbon.continuity < Continuity::G1) {
        return Vector2d::Zero();
    }
    const RibbonPoint p = ribbon.at(s - side);
    return gradient_of(boundary_.frame, p.normal) -
           field_.gradient(boundary_.coordinates(p.point).head<2>());
}

Lift::Spoke Lift::spoke(const SplineCurve& gamma, const Course& course, double s) const {
    const Vector2d a = axis_.nodes[static_cast<std::size_t>(course.start)];
    const Vector2d b = axis_.nodes[static_cast<std::size_t>(course.end)];
    const double part = std::clamp((s - course.from) / (course.to - course.from), 0.0, 1.0);
    const int side = std::clamp(static_cast<int>(std::floor(s)), 0, boundary_.count() - 1);
    Spoke spoke;
    spoke.from = evaluate(gamma, s).col(0);
    const Vector2d at = spoke.from.head<2>();
    spoke.along = a + part * (b - a) - at;
    const LiftedAxis::Point end = lifted_axis_.at(course, s);
    spoke.end_slope = end.gradient.dot(spoke.along);
    spoke.end_height = end.height;
    spoke.missed_height = spoke.from.z() - field_.height(at);
    // At corners the field is left as it is: both sides share that spoke, and its neighbourhood.
    const double kept =
        (1.0 - fading((s - side) / kFade)) * (1.0 - fading((side + 1.0 - s) / kFade));
    spoke.missed_slope = kept * missed_gradient(side, s).dot(spoke.along);
    spoke.start_slope = field_.gradient(at).dot(spoke.along) + spoke.missed_slope;
    return spoke;
}

double Lift::height(const Spoke& spoke, double t) const {
    const double left = (1.0 - t) * (1.0 - t);
    return field_.height(spoke.from.head<2>() + t * spoke.along) +
           left * (1.0 + 2.0 * t) * spoke.missed_height + left * t * spoke.missed_slope;
}

VectorXd Lift::heights(const Spoke& spoke, const CompleteCubic& radial) const {
    VectorXd data(radial.count() - 1);
    data[0] = spoke.start_slope;
    for (int k = 1; k < radial.spans(); ++k) {
        data[k] = height(spoke, static_cast<double>(k) / radial.spans());
    }
    data[radial.spans()] = spoke.end_slope;
    data[radial.spans() + 1] = spoke.end_height;
    return data;
}

/// As few spans as make z accurate along some spokes; all surfaces have the same, for their seams.
void Lift::choose_radial_spans() {
    double error = INFINITY;
    for (int spans = 1; spans <= kMostSpans && error > accuracy_; spans *= 2) {
        const CompleteCubic radial(spans);
        error = 0.0;
        for (const Course& course : courses(axis_)) {
            for (int k = 0; k < kTrialSpokes; ++k) {
                const double s = course.from + (course.to - course.from) * (k + 0.5) / kTrialSpokes;
                const double on_turn = s - axis_.period * std::floor(s / axis_.period);
                const auto side = static_cast<std::size_t>(on_turn);
                Course turned = course;
                turned.from += on_turn - s;
                turned.to += on_turn - s;
                const Spoke trial = spoke(sides_[side], turned, on_turn);
                MatrixXd data(1, radial.count());
                data << trial.from.z(), heights(trial, radial).transpose();
                const SplineCurve z = radial.spline(data);
                for (int i = 0; i < spans; ++i) {
                    for (const double part : {0.2, 0.5, 0.8}) {
                        const double t = (i + part) / spans;
                        error = std::max(error, std::abs(evaluate(z, t)(0, 0) - height(trial, t)));
                    }
                }
            }
        }
        radial_ = radial;
    }
    error_ = std::max(error_, error);
}

/// In the frame's coordinates.
SplineCurve Lift::local(SplineCurve curve) const {
    for (int k = 0; k < curve.count(); ++k) {
        curve.poles.col(k) = boundary_.coordinates(curve.poles.col(k));
    }
    return curve;
}

/// Where z is not smooth in s.
std::vector<Break> Lift::breaks(const SplineCurve& gamma, const Region& region) const {
    std::vector<Break> found;
    for (const double knot : gamma.knots) {
        const auto times = std::count(gamma.knots.begin(), gamma.knots.end(), knot);
        found.push_back({knot, times < gamma.degree ? 1 : 0});
    }
    for (const Course& course : region.courses) {
        found.push_back({course.from, 0});
        for (const double at : lifted_axis_.breaks(course)) {
            found.push_back({at, 1});
        }
    }
    for (int side = region.first; side < region.first + region.count; ++side) {
        const auto& conflicts = conflicts_[static_cast<std::size_t>(side)];
        for (const int end : {0, 1}) {
            if (conflicts.at(static_cast<std::size_t>(end)) > kConflict) {
                found.push_back({side + end + (end == 0 ? kFade : -kFade), 2});
            }
        }
    }
    return sorted(std::move(found));
}

SplineSurface Lift::surface(const Region& region) {
    SplineCurve gamma = local(region.side);
    const auto course = [&](double s) -> const Course& {
        const auto at = std::find_if(region.courses.begin(), region.courses.end(),
                                     [&](const Course& c) { return s <= c.to; });
        return at == region.courses.end() ? region.courses.back() : *at;
    };
    // What lies on the axis is a polynomial of two degrees more than gamma.
    const SplineCurve side = gamma;
    FittedCurve fit =
        fit_curve([&](double s) { return heights(spoke(side, course(s), s), radial_); },
                  breaks(gamma, region), std::max(kDegree, gamma.degree + 2), accuracy_);
    error_ = std::max(error_, fit.error);
    SplineCurve foot = linear_spline(region.courses, axis_.nodes);
    make_compatible(gamma, foot);
    make_compatible(gamma, fit.curve);
    make_compatible(gamma, foot);
    std::vector<SplineCurve> rows(static_cast<std::size_t>(radial_.count()), gamma);
    for (int k = 0; k < gamma.count(); ++k) {
        const Vector3d from = gamma.poles.col(k);
        const Vector2d to = foot.poles.col(k);
        MatrixXd data(1, radial_.count());
        data << from.z(), fit.curve.poles.col(k).transpose();
        const MatrixXd z = radial_.poles(data);
        for (int j = 0; j < radial_.count(); ++j) {
            const double t = radial_.greville(j);
            const Vector2d xy = (1.0 - t) * from.head<2>() + t * to;
            rows[static_cast<std::size_t>(j)].poles.col(k) =
                boundary_.lifted(xy) + z(0, j) * boundary_.frame.z;
        }
    }
    rows.front().poles = [&] {
        SplineCurve exact = region.side;
        SplineCurve knots = gamma;
        make_compatible(exact, knots);
        return exact.poles;
    }();
    collapse_rests(rows.back(), region.courses, [&](int node) { return vertex(node); });
    return from_rows(rows, radial_.knots());
}

}  // namespace suture::concentric

#include "suture/fill/concentric/lift.h"

#include "suture/fill/concentric/certificate.h"
#include "suture/fill/concentric/fit.h"
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
constexpr double kMostLean = radians(60.0);

/// Degree in s of what is fitted.
constexpr int kDegree = 5;

/// Samples of the height field for a side, as many as make kSamples in all and not fewer than four.
constexpr int kSamples = 96;

/// A fit is finer than the wanted angle by this factor.
constexpr double kFitShare = 0.01;

/// The share of a side over which a jump of the slope at its corner is spread.
constexpr double kSpread = 0.2;

/// The gradient of the tangent plane with this normal, as a height over the frame's plane.
Vector2d gradient_of(const Frame& frame, const Vector3d& normal) {
    return Vector2d(-normal.dot(frame.x), -normal.dot(frame.y)) / normal.dot(frame.z);
}

/// From 1 at 0 to 0 at 1 and beyond, with zero slopes.
double fading(double x) {
    return x >= 1.0 ? 0.0 : (1.0 - x) * (1.0 - x) * (1.0 + 2.0 * x);
}

/// The step that nearly rests at both ends.
double resting_step(double x) {
    return kRestingSpeed * x + (1.0 - kRestingSpeed) * x * x * (3.0 - 2.0 * x);
}

/// Curves that begin where the last one ends, as one.
void append(SplineCurve& all, const SplineCurve& next) {
    if (all.knots.empty()) {
        all = next;
        return;
    }
    MatrixXd poles(all.poles.rows(), all.count() + next.count() - 1);
    poles << all.poles, next.poles.rightCols(next.count() - 1);
    all.knots.pop_back();
    all.knots.insert(all.knots.end(), next.knots.begin() + next.degree + 1, next.knots.end());
    all.poles = std::move(poles);
}

}  // namespace

Result<Lift> Lift::make(const Hole& hole, const Boundary& boundary, const ConcentricCurve& axis,
                        const Tolerance& tolerance) {
    const auto& ribbons = hole.loops.front().ribbons;
    const int per_side = std::max(4, kSamples / static_cast<int>(ribbons.size()));
    std::vector<HeightSample> samples;
    for (const Ribbon& ribbon : ribbons) {
        for (int k = 0; k < per_side; ++k) {
            const RibbonPoint p = ribbon.at((k + 0.5) / per_side);
            const double lean = std::acos(std::clamp(p.normal.dot(boundary.frame.z), -1.0, 1.0));
            const Vector3d local = boundary.coordinates(p.point);
            HeightSample sample{local.head<2>(), local.z()};
            if (ribbon.continuity >= Continuity::G1) {
                if (lean > kMostLean) {
                    return fail(ErrorCode::Refused,
                                "the neighbour at {} leans by {:.1f} deg from the hole's mean "
                                "plane (limit {:.0f}): no surface over that plane is tangent to it",
                                name_of(ribbon), degrees(lean), degrees(kMostLean));
                }
                const Vector2d inward(p.inward.dot(boundary.frame.x),
                                      p.inward.dot(boundary.frame.y));
                sample.direction = inward.normalized();
                sample.slope = sample.direction.dot(gradient_of(boundary.frame, p.normal));
            }
            samples.push_back(sample);
        }
    }
    double reach = INFINITY;
    for (const Stop& stop : axis.stops) {
        for (const HeightSample& sample : samples) {
            reach = std::min(reach, (axis.node(stop) - sample.at).norm());
        }
    }
    return Lift(hole, boundary, axis, HeightField(samples),
                kFitShare * std::min(tolerance.angular * reach, tolerance.linear));
}

Vector3d Lift::vertex(int node) const {
    const Vector2d& at = axis_.nodes[static_cast<std::size_t>(node)];
    return boundary_.lifted(at) + field_.height(at) * boundary_.frame.z;
}

/// The concentric curve with its heights, in the frame's coordinates. Both sides of an edge of the
/// axis get the same curve, by symmetry.
SplineCurve Lift::axis_row(const Region& region) {
    SplineCurve row;
    for (const Course& course : region.courses) {
        const Vector2d& a = axis_.nodes[static_cast<std::size_t>(course.start)];
        const Vector2d& b = axis_.nodes[static_cast<std::size_t>(course.end)];
        const auto at = [&](double s) -> VectorXd {
            const double x = (s - course.from) / (course.to - course.from);
            const Vector2d xy = a + (b - a) * resting_step(x);
            return Vector3d(xy.x(), xy.y(), field_.height(xy));
        };
        FittedCurve fit = fit_curve(at, {course.from, course.to}, kDegree, accuracy_);
        error_ = std::max(error_, fit.error);
        append(row, fit.curve);
    }
    return row;
}

/// The gradient that the surface has at the boundary: the neighbour's, or the height field's own
/// where position alone is wanted.
Vector2d Lift::boundary_gradient(int side, double s) const {
    const Ribbon& ribbon = hole_.loops.front().ribbons[static_cast<std::size_t>(side)];
    const RibbonPoint p = ribbon.at(s - side);
    return ribbon.continuity >= Continuity::G1
               ? gradient_of(boundary_.frame, p.normal)
               : field_.gradient(boundary_.coordinates(p.point).head<2>());
}

/// The slope along a spoke. Where the neighbours at a corner have different normals, both sides
/// fade to the mean there: the faces on either side share that spoke.
double Lift::boundary_slope(double s, const Vector2d& spoke) const {
    const int n = boundary_.count();
    const int side = std::clamp(static_cast<int>(std::floor(s)), 0, n - 1);
    Vector2d gradient = boundary_gradient(side, s);
    for (const int corner : {side, side + 1}) {
        const double fade = fading(std::abs(s - corner) / kSpread);
        if (fade > 0.0) {
            const int before = (corner + n - 1) % n;
            const Vector2d left = boundary_gradient(before, before + 1.0);
            const Vector2d right = boundary_gradient(corner % n, corner % n);
            gradient += 0.5 * fade * (corner == side ? left - right : right - left);
        }
    }
    return gradient.dot(spoke);
}

SplineSurface Lift::surface(const Region& region) {
    SplineCurve gamma = region.side;
    SplineCurve foot = axis_row(region);
    for (int k = 0; k < gamma.count(); ++k) {
        gamma.poles.col(k) = boundary_.coordinates(gamma.poles.col(k));
    }
    // The slopes of both ends of each spoke, per unit of t.
    std::vector<double> breaks = gamma.knots;
    for (const Course& course : region.courses) {
        breaks.push_back(course.from);
    }
    std::sort(breaks.begin(), breaks.end());
    breaks.erase(std::unique(breaks.begin(), breaks.end()), breaks.end());
    const auto slopes = [&](double s) -> VectorXd {
        const Vector3d from = evaluate(gamma, s).col(0);
        const Vector3d to = evaluate(foot, s).col(0);
        const Vector2d spoke = (to - from).head<2>();
        return Vector2d(boundary_slope(s, spoke), field_.gradient(to.head<2>()).dot(spoke));
    };
    FittedCurve fit = fit_curve(slopes, breaks, kDegree, accuracy_);
    error_ = std::max(error_, fit.error);
    make_compatible(gamma, foot);
    make_compatible(gamma, fit.curve);
    make_compatible(gamma, foot);
    std::vector<SplineCurve> rows(4, gamma);
    rows[3] = foot;
    for (int k = 0; k < gamma.count(); ++k) {
        const Vector3d a = gamma.poles.col(k);
        const Vector3d b = foot.poles.col(k);
        Vector3d d = b - a;
        d.z() = fit.curve.poles(0, k);
        rows[1].poles.col(k) = a + d / 3.0;
        d.z() = fit.curve.poles(1, k);
        rows[2].poles.col(k) = b - d / 3.0;
    }
    for (SplineCurve& row : rows) {
        for (int k = 0; k < row.count(); ++k) {
            const Vector3d local = row.poles.col(k);
            row.poles.col(k) = boundary_.lifted(local.head<2>()) + local.z() * boundary_.frame.z;
        }
    }
    return from_rows(rows);
}

}  // namespace suture::concentric

#include "suture/fill/concentric/boundary.h"

#include "suture/fill/concentric/fit.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace suture::concentric {
namespace {

using Eigen::Vector3d;

/// Degree of what is fitted: a circle then takes few spans.
constexpr int kFitDegree = 5;

/// A fit may miss its accuracy by this factor before the side is refused.
constexpr double kMostMiss = 10.0;

/// Samples of a side for the area vector and the height.
constexpr int kSamples = 64;

/// Side i of a loop on [i, i + 1].
Result<SplineCurve> side_of(const Ribbon& ribbon, int index, double accuracy, double& error) {
    if (ribbon.curve) {
        SplineCurve curve = *ribbon.curve;
        for (double& knot : curve.knots) {
            knot += index;
        }
        return curve;
    }
    const auto at = [&](double s) -> Eigen::VectorXd { return ribbon.at(s - index).point; };
    FittedCurve fit = fit_curve(at, {{1.0 * index}, {index + 1.0}}, kFitDegree, accuracy);
    if (!(fit.error <= kMostMiss * accuracy)) {
        return fail(ErrorCode::Refused,
                    "{} is no smooth curve: a B-spline comes within {:.3g} only", name_of(ribbon),
                    fit.error);
    }
    error = std::max(error, fit.error);
    return fit.curve;
}

/// Where one side ends and the next begins there is one point: the mean of both.
void close_corners(std::vector<SplineCurve>& sides) {
    for (std::size_t i = 0; i < sides.size(); ++i) {
        SplineCurve& before = sides[i];
        SplineCurve& after = sides[(i + 1) % sides.size()];
        const Vector3d corner = 0.5 * (before.poles.col(before.count() - 1) + after.poles.col(0));
        if (sides.size() == 1) {
            before.poles.col(0) = corner;
        }
        before.poles.col(before.count() - 1) = corner;
        after.poles.col(0) = corner;
    }
}

/// The frame whose z is along the loop's area vector.
Frame frame_of(const std::vector<SplineCurve>& sides) {
    std::vector<Vector3d> points;
    for (const SplineCurve& side : sides) {
        for (int k = 0; k < kSamples; ++k) {
            const double s = side.begin() + static_cast<double>(k) / kSamples;
            points.emplace_back(evaluate(side, s));
        }
    }
    Frame frame;
    frame.origin.setZero();
    for (const Vector3d& point : points) {
        frame.origin += point / static_cast<double>(points.size());
    }
    Vector3d area = Vector3d::Zero();
    for (std::size_t k = 0; k < points.size(); ++k) {
        area += (points[k] - frame.origin).cross(points[(k + 1) % points.size()] - frame.origin);
    }
    frame.z = area.normalized();
    frame.x = frame.z.unitOrthogonal();
    frame.y = frame.z.cross(frame.x);
    return frame;
}

}  // namespace

Result<Boundary> boundary_of(const Hole& hole, double accuracy) {
    if (hole.loops.size() > 1) {
        return fail(ErrorCode::Refused,
                    "the hole has {} islands, the first at {}: a disc-like surface has none",
                    hole.loops.size() - 1, name_of(hole.loops[1].ribbons.front()));
    }
    Boundary boundary;
    int degree = 1;
    for (const Ribbon& ribbon : hole.loops.front().ribbons) {
        auto side = side_of(ribbon, boundary.count(), accuracy, boundary.error);
        if (!side) {
            return tl::unexpected(side.error());
        }
        degree = std::max(degree, side->degree);
        boundary.sides.push_back(std::move(*side));
    }
    close_corners(boundary.sides);
    boundary.frame = frame_of(boundary.sides);
    std::vector<SplineCurve> planar;
    for (int i = 0; i < boundary.count(); ++i) {
        const SplineCurve& side = boundary.sides[static_cast<std::size_t>(i)];
        SplineCurve flat{side.degree, side.knots, Eigen::MatrixXd(2, side.count())};
        for (int k = 0; k < side.count(); ++k) {
            const Vector3d local = boundary.coordinates(side.poles.col(k));
            flat.poles.col(k) = local.head<2>();
        }
        planar.push_back(elevated(flat, degree));
        for (int k = 0; k <= kSamples; ++k) {
            const double s = i + static_cast<double>(k) / kSamples;
            const double z = boundary.coordinates(evaluate(side, s).col(0)).z();
            if (std::abs(z) > boundary.height) {
                boundary.height = std::abs(z);
                boundary.highest = i;
            }
        }
    }
    boundary.planar = closed_from(planar);
    return boundary;
}

}  // namespace suture::concentric

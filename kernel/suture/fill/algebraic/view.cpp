#include "suture/fill/algebraic/view.h"

#include <Eigen/Geometry>
#include <Eigen/QR>

#include <algorithm>
#include <cmath>
#include <optional>

namespace suture::algebraic {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

/// The least cosine between rays and normals: what a ray crosses at less is too oblique to find.
constexpr double kLeastFacing = 0.12;
/// How far off the far centre lies, in units of the hole's radius.
constexpr double kFar = 6.0;
/// How nearly planes have to meet in a point.
constexpr double kMeet = 1e-8;

/// Where the planes of all bent sides meet.
std::optional<Vector3d> common_point(const std::vector<SideShape>& shapes) {
    Eigen::MatrixX3d A(0, 3);
    Eigen::VectorXd b(0);
    for (const SideShape& shape : shapes) {
        if (!shape.straight) {
            const auto& c = shape.plane.coefficients;
            A.conservativeResize(A.rows() + 1, 3);
            b.conservativeResize(A.rows());
            A.bottomRows(1) << c[1], c[2], c[3];
            b[b.size() - 1] = -c[0];
        }
    }
    if (A.rows() < 3) {
        return std::nullopt;
    }
    Eigen::ColPivHouseholderQR<Eigen::MatrixX3d> qr(A);
    constexpr double kIndependent = 1e-3;
    qr.setThreshold(kIndependent);
    if (qr.rank() < 3) {
        return std::nullopt;
    }
    const Vector3d point = qr.solve(b);
    return (A * point - b).cwiseAbs().maxCoeff() <= kMeet ? std::optional(point) : std::nullopt;
}

/// The direction whose largest angle with the normals is least, nearly.
Vector3d axis_of(const std::vector<GuidePoint>& guide) {
    Vector3d axis = Vector3d::Zero();
    for (const GuidePoint& g : guide) {
        axis += g.normal;
    }
    axis.normalize();
    constexpr int kSteps = 400;
    for (int step = 1; step <= kSteps; ++step) {
        const auto worst = std::min_element(guide.begin(), guide.end(),
                                            [&](const GuidePoint& a, const GuidePoint& b) {
                                                return a.normal.dot(axis) < b.normal.dot(axis);
                                            });
        axis = (axis + worst->normal / (1.0 + step)).normalized();
    }
    return axis;
}

/// The least cosine between rays and normals with the sign of most of them.
double facing(const std::vector<GuidePoint>& guide, const Vector3d& centre, double sign) {
    double least = 1.0;
    for (const GuidePoint& g : guide) {
        least = std::min(least, sign * g.normal.dot((g.point - centre).normalized()));
    }
    return least;
}

/// Central projection to a plane across the axis.
class Screen {
  public:
    Screen(const Vector3d& centre, const std::vector<GuidePoint>& guide) : centre_(centre) {
        Vector3d middle = Vector3d::Zero();
        for (const GuidePoint& g : guide) {
            middle += g.point / static_cast<double>(guide.size());
        }
        axis_ = (middle - centre).normalized();
        x_ = axis_.unitOrthogonal();
        y_ = axis_.cross(x_);
    }
    [[nodiscard]] bool sees(const Vector3d& p) const { return axis_.dot(p - centre_) > 0.0; }
    [[nodiscard]] Vector2d operator()(const Vector3d& p) const {
        const Vector3d d = p - centre_;
        return Vector2d(x_.dot(d), y_.dot(d)) / axis_.dot(d);
    }

  private:
    Vector3d centre_, axis_, x_, y_;
};

/// The guide's point that keeps the most from the lines along the boundary, which it sees to its
/// left: from there all of the boundary is in sight.
std::optional<Vector3d> outer_point(const std::vector<UnitCurve>& curves,
                                    const std::vector<GuidePoint>& guide, const Vector3d& centre,
                                    double sign) {
    const Screen screen(centre, guide);
    constexpr int kSamples = 24;
    std::vector<Vector2d> boundary;
    for (const UnitCurve& curve : curves) {
        for (int n = 0; n < kSamples; ++n) {
            const Vector3d p = curve(static_cast<double>(n) / kSamples);
            if (!screen.sees(p)) {
                return std::nullopt;
            }
            boundary.push_back(screen(p));
        }
    }
    std::optional<Vector3d> best;
    double most = 0.0;
    for (const GuidePoint& g : guide) {
        const Vector2d o = screen(g.point);
        double least = INFINITY;
        for (std::size_t i = 0; i < boundary.size(); ++i) {
            const Vector2d a = boundary[i] - o;
            const Vector2d b = boundary[(i + 1) % boundary.size()] - o;
            least = std::min(least, sign * (a.x() * b.y() - a.y() * b.x()) / (b - a).norm());
        }
        if (least > most) {
            most = least;
            best = g.point;
        }
    }
    return best;
}

}  // namespace

Result<View> find_view(const std::vector<UnitCurve>& curves, const std::vector<SideShape>& shapes,
                       const std::vector<GuidePoint>& guide) {
    std::vector<std::pair<Vector3d, bool>> centres;
    if (const auto common = common_point(shapes)) {
        centres.emplace_back(*common, true);
    }
    const Vector3d axis = axis_of(guide);
    centres.emplace_back(-kFar * axis, false);
    double best_facing = -1.0;
    for (const auto& [centre, concurrent] : centres) {
        for (const double sign : {1.0, -1.0}) {
            const double least = facing(guide, centre, sign);
            best_facing = std::max(best_facing, least);
            if (least < kLeastFacing) {
                continue;
            }
            if (const auto outer = outer_point(curves, guide, centre, sign)) {
                return View{centre, *outer, sign, concurrent};
            }
        }
    }
    if (best_facing < kLeastFacing) {
        return fail(ErrorCode::Refused,
                    "the normals spread so far that from every centre tried rays meet the surface "
                    "at {:.3g} deg or less, at least {:.3g} are needed",
                    degrees(std::asin(best_facing)), degrees(std::asin(kLeastFacing)));
    }
    return fail(ErrorCode::Refused,
                "no point inside sees all of the boundary, so that cells around an axis overlap");
}

}  // namespace suture::algebraic

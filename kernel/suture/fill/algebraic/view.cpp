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
constexpr double kLeastFacing = 0.08;
/// How far off the far centre lies, in units of the hole's radius.
constexpr double kFar = 6.0;
/// Where the search for a nearer centre begins, in units of the hole's radius.
constexpr double kNear[] = {0.7, 2.0};
/// How nearly planes have to meet in a point.
constexpr double kMeet = 1e-8;

/// Where the planes of all bent sides meet.
std::optional<Vector3d> common_point(const std::vector<SideShape>& shapes) {
    Eigen::MatrixX3d A(0, 3);
    Eigen::VectorXd b(0);
    for (const SideShape& shape : shapes) {
        if (shape.plane) {
            const auto& c = shape.plane->coefficients;
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

/// From where a surface is looked at.
struct Viewpoint {
    Vector3d point;
    double sign = 1.0;
    bool concurrent = false;
};

/// The centre near the given one with the highest score, by compass search.
template <class Score>
Viewpoint climbed(Viewpoint centre, const Score& score) {
    constexpr double kFirstStep = 0.5;
    constexpr double kLastStep = 0.01;
    constexpr int kMoves = 200;
    double best = score(centre);
    int moves = 0;
    for (double step = kFirstStep; step > kLastStep && moves < kMoves;) {
        bool moved = false;
        for (int axis = 0; axis < 6; ++axis, ++moves) {
            Viewpoint to = centre;
            to.point += (axis < 3 ? step : -step) * Vector3d::Unit(axis % 3);
            const double here = score(to);
            if (here > best && to.point.norm() < kFar) {
                best = here;
                centre = to;
                moved = true;
            }
        }
        step *= moved ? 1.0 : 0.5;
    }
    return centre;
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

/// A point of the surface, and how well it sees the boundary.
struct Sighting {
    Vector3d point = Vector3d::Zero();
    double clearance = -INFINITY;  ///< negative: some of the boundary is out of sight
};

/// The guide's point that keeps the most from the lines along the boundary, which it sees to its
/// left: from there all of the boundary is in sight.
///
/// Input    every: only each such point of the guide is tried.
Sighting outer_point(const std::vector<Vector3d>& boundary, const std::vector<GuidePoint>& guide,
                     const Viewpoint& centre, std::size_t every = 1) {
    const Screen screen(centre.point, guide);
    Sighting best;
    std::vector<Vector2d> seen;
    for (const Vector3d& p : boundary) {
        if (!screen.sees(p)) {
            return best;
        }
        seen.push_back(screen(p));
    }
    for (std::size_t k = 0; k < guide.size(); k += every) {
        const Vector2d o = screen(guide[k].point);
        double least = INFINITY;
        for (std::size_t i = 0; i < seen.size() && least > best.clearance; ++i) {
            const Vector2d a = seen[i] - o;
            const Vector2d b = seen[(i + 1) % seen.size()] - o;
            least = std::min(least, centre.sign * (a.x() * b.y() - a.y() * b.x()) / (b - a).norm());
        }
        if (least > best.clearance) {
            best = {guide[k].point, least};
        }
    }
    return best;
}

std::vector<Vector3d> boundary_of(const std::vector<UnitCurve>& curves) {
    constexpr int kSamples = 24;
    std::vector<Vector3d> boundary;
    for (const UnitCurve& curve : curves) {
        for (int n = 0; n < kSamples; ++n) {
            boundary.push_back(curve(static_cast<double>(n) / kSamples));
        }
    }
    return boundary;
}

}  // namespace

Result<View> find_view(const std::vector<UnitCurve>& curves, const std::vector<SideShape>& shapes,
                       const std::vector<GuidePoint>& guide) {
    const std::vector<Vector3d> boundary = boundary_of(curves);
    const auto facing_at = [&](const Viewpoint& c) { return facing(guide, c.point, c.sign); };
    double best_facing = -1.0;
    const auto view_from = [&](const Viewpoint& c) -> std::optional<View> {
        const double least = facing_at(c);
        best_facing = std::max(best_facing, least);
        if (least < kLeastFacing) {
            return std::nullopt;
        }
        const Sighting outer = outer_point(boundary, guide, c);
        return outer.clearance > 0.0
                   ? std::optional(View{c.point, outer.point, c.sign, c.concurrent})
                   : std::nullopt;
    };
    std::vector<Viewpoint> centres;
    if (const auto common = common_point(shapes)) {
        centres.push_back({*common, 1.0, true});
        centres.push_back({*common, -1.0, true});
    }
    const Vector3d axis = axis_of(guide);
    centres.push_back({-kFar * axis, 1.0, false});
    // A half-round blend is seen from its own axis only, from the front or from behind.
    for (const double distance : kNear) {
        centres.push_back(climbed({-distance * axis, 1.0, false}, facing_at));
        centres.push_back(climbed({distance * axis, -1.0, false}, facing_at));
    }
    for (const Viewpoint& centre : centres) {
        if (const auto view = view_from(centre)) {
            return *view;
        }
    }
    // A centre that sees the surface well and, from some point of it, all of the boundary.
    constexpr std::size_t kEvery = 7;
    const auto seeing = [&](const Viewpoint& c) {
        return std::min(facing_at(c) - kLeastFacing,
                        outer_point(boundary, guide, c, kEvery).clearance);
    };
    for (Viewpoint centre : centres) {
        centre.concurrent = false;
        if (const auto view = view_from(climbed(centre, seeing))) {
            return *view;
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

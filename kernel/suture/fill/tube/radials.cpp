#include "suture/fill/tube/radials.h"

#include "suture/base/tolerance.h"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <vector>

namespace suture::tube {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr int kSamples = 48;  // per side, ends included: there it is seen worst

/// The closing point is moved in the plane until every side sees it at this angle (its sine) above
/// its own direction; if none can be reached, at the next. Below the last a hole is not
/// star-shaped.
constexpr double kSeen[] = {0.5, 0.3, 0.2, 0.1, 0.05, 0.02, 0.01};
constexpr int kMostMoves = 400;
/// A move aims so much deeper, else it would only come ever nearer to the limit.
constexpr double kDeeper = 0.02;

struct Sight {
    const Ribbon* ribbon;
    Vector2d point;
    Vector2d inward;
};

double sine(const Sight& sight, const Vector2d& centre) {
    const Vector2d towards = centre - sight.point;
    return sight.inward.dot(towards) / towards.norm();
}

const Sight& worst_of(const std::vector<Sight>& sights, const Vector2d& centre) {
    return *std::min_element(sights.begin(), sights.end(), [&](const Sight& a, const Sight& b) {
        return sine(a, centre) < sine(b, centre);
    });
}

/// The centre moved, over and over towards the inside of the side that sees it worst, until all
/// see it: the places that they see make a convex region, to which every move comes nearer.
std::optional<Vector2d> moved_into_sight(const std::vector<Sight>& sights, Vector2d centre,
                                         double least) {
    for (int move = 0; move < kMostMoves; ++move) {
        const Sight& worst = worst_of(sights, centre);
        const double missing = least - sine(worst, centre);
        if (missing <= 0.0) {
            return centre;
        }
        centre += std::max(missing, kDeeper) * (centre - worst.point).norm() * worst.inward;
    }
    return std::nullopt;
}

tl::unexpected<Error> not_star_shaped(const Ribbon& ribbon, double sine) {
    return fail(ErrorCode::Refused,
                "the hole is not star-shaped: {} sees the closing point at {:.3g} deg from its "
                "inside (limit {:.2g})",
                name_of(ribbon), degrees(std::asin(std::clamp(sine, -1.0, 1.0))),
                degrees(std::asin(std::end(kSeen)[-1])));
}

std::vector<Sight> sights_of(const RibbonLoop& loop, const mvs::Layout& layout) {
    std::vector<Sight> sights;
    for (std::size_t i = 0; i < loop.ribbons.size(); ++i) {
        for (int k = 0; k < kSamples; ++k) {
            const double s = static_cast<double>(k) / (kSamples - 1);
            const Vector2d along = layout.curves[i].derivative(s).normalized();
            sights.push_back(
                {&loop.ribbons[i], layout.curves[i].at(s), Vector2d(-along.y(), along.x())});
        }
    }
    return sights;
}

/// The centroid of the area that a layout encloses.
Vector2d centroid(const std::vector<Sight>& sights) {
    Vector2d sum = Vector2d::Zero();
    double area = 0.0;
    for (std::size_t k = 0; k < sights.size(); ++k) {
        const Vector2d& a = sights[k].point;
        const Vector2d& b = sights[(k + 1) % sights.size()].point;
        const double twice = a.x() * b.y() - a.y() * b.x();
        sum += twice * (a + b) / 3.0;
        area += twice;
    }
    return sum / area;
}

}  // namespace

Result<Radials> Radials::from_point(const RibbonLoop& loop, const Vector3d& point) {
    for (const Ribbon& ribbon : loop.ribbons) {
        for (int k = 0; k < kSamples; ++k) {
            const RibbonPoint at = ribbon.at(static_cast<double>(k) / (kSamples - 1));
            const Vector3d towards = point - at.point;
            const double seen = at.inward.dot(towards) / towards.norm();
            if (ribbon.continuity >= Continuity::G1 && !(seen >= std::end(kSeen)[-1])) {
                return not_star_shaped(ribbon, seen);
            }
        }
    }
    Radials radials;
    radials.point_ = point;
    return radials;
}

Result<Radials> Radials::developed(const RibbonLoop& loop, double diameter) {
    auto layout = mvs::lay_out(loop, diameter);
    if (!layout) {
        return tl::unexpected(layout.error());
    }
    const std::vector<Sight> sights = sights_of(loop, *layout);
    Radials radials;
    radials.centre_ = centroid(sights);
    const Sight& worst = worst_of(sights, radials.centre_);
    const double seen = sine(worst, radials.centre_);
    radials.layout_ = std::move(*layout);
    for (const double least : kSeen) {
        if (const auto centre = moved_into_sight(sights, radials.centre_, least)) {
            radials.centre_ = *centre;
            return radials;
        }
    }
    return not_star_shaped(*worst.ribbon, seen);
}

Vector2d Radials::in_plane(int side, double s) const {
    return layout_->curves[static_cast<std::size_t>(side)].at(s) - centre_;
}

Vector3d Radials::centre_in_space(const RibbonLoop& loop) const {
    Eigen::Matrix3d flat = Eigen::Matrix3d::Zero();
    Eigen::Matrix3d mixed = Eigen::Matrix3d::Zero();
    for (std::size_t i = 0; i < loop.ribbons.size(); ++i) {
        for (int k = 0; k < kSamples; ++k) {
            const double s = (k + 0.5) / kSamples;
            const RibbonPoint at = loop.ribbons[i].at(s);
            const Vector3d place = in_plane(static_cast<int>(i), s).homogeneous();
            const double length = at.tangent.norm();
            flat += length * place * place.transpose();
            mixed += length * at.point * place.transpose();
        }
    }
    // In the plane the centre is the origin.
    return mixed * flat.ldlt().solve(Vector3d::UnitZ());
}

Vector3d Radials::outward(int side, double s, const RibbonPoint& at) const {
    if (layout_) {
        const auto i = static_cast<std::size_t>(side);
        const Vector2d along = layout_->curves[i].derivative(s).normalized();
        const Vector2d from = in_plane(side, s);
        return along.dot(from) * at.tangent.normalized() +
               (along.x() * from.y() - along.y() * from.x()) * at.inward;
    }
    const Vector3d from = at.point - point_;
    const Vector3d flat = from - at.normal * at.normal.dot(from);
    return flat * (from.norm() / flat.norm());
}

}  // namespace suture::tube

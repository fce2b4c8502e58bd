#include "suture/fill/tube/radials.h"

#include "suture/base/tolerance.h"

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

/// Below this turn of the border in the plane a corner is none.
constexpr double kCorner = radians(2.0);

double turn_between(const mvs::DomainCurve& before, const mvs::DomainCurve& after) {
    const Vector2d a = before.derivative(1.0);
    const Vector2d b = after.derivative(0.0);
    return std::atan2(a.x() * b.y() - a.y() * b.x(), a.dot(b));
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

Vector3d Radials::outward(int side, double s, const RibbonPoint& at) const {
    if (layout_) {
        const auto i = static_cast<std::size_t>(side);
        const std::size_t n = layout_->curves.size();
        const Vector2d along = layout_->curves[i].derivative(s).normalized();
        Vector2d from = in_plane(side, s);
        // Deviation: towards a corner the radial turns into the bisector, since the columns near a
        // corner cross where it leaves along a side; from the middle of the side on it is radial.
        const double share = (1.0 - 2.0 * s) * (1.0 - 2.0 * s);
        const double turn = s < 0.5
                                ? turn_between(layout_->curves[(i + n - 1) % n], layout_->curves[i])
                                : turn_between(layout_->curves[i], layout_->curves[(i + 1) % n]);
        if (std::abs(turn) > kCorner) {
            const Vector2d bisector =
                Eigen::Rotation2Dd(-0.5 * kPi) *
                (Eigen::Rotation2Dd((s < 0.5 ? -1.0 : 1.0) * 0.5 * turn) * along);
            from =
                from.norm() * ((1.0 - share) * from.normalized() + share * bisector).normalized();
        }
        return along.dot(from) * at.tangent.normalized() +
               (along.x() * from.y() - along.y() * from.x()) * at.inward;
    }
    const Vector3d from = at.point - point_;
    const Vector3d flat = from - at.normal * at.normal.dot(from);
    return flat * (from.norm() / flat.norm());
}

}  // namespace suture::tube

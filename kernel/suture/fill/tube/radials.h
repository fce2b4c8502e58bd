#pragma once

#include "suture/base/result.h"
#include "suture/fill/mvs/layout.h"
#include "suture/model/ribbon.h"

#include <Eigen/Core>

#include <optional>

namespace suture::tube {

/// The direction across the border in which the tube leaves it, for every place of every side: in
/// the neighbour's tangent plane, outwards, as long as the way from the closing point.
class Radials {
  public:
    /// From a given point: the projection of c - point on the tangent plane.
    ///
    /// Refuses  a side that does not see the point inside: the hole is not star-shaped from there.
    static Result<Radials> from_point(const RibbonLoop& loop, const Eigen::Vector3d& point);

    /// From the middle of the border laid out in the plane as its sides turn on their neighbours,
    /// so that it need not be seen in space.
    ///
    /// Refuses  a border that is not star-shaped in the plane either.
    static Result<Radials> developed(const RibbonLoop& loop, double diameter);

    /// The vector at a place of a side; `at` is what the ribbon has there.
    [[nodiscard]] Eigen::Vector3d outward(int side, double s, const RibbonPoint& at) const;

    /// Where the place lies in the plane, seen from the closing point there; only if developed.
    [[nodiscard]] Eigen::Vector2d in_plane(int side, double s) const;
    /// Where the closing point of the plane lies in space under the affine map that brings the
    /// layout nearest to the border: of a planar hole, its own place. Only if developed.
    [[nodiscard]] Eigen::Vector3d centre_in_space(const RibbonLoop& loop) const;
    [[nodiscard]] bool is_developed() const { return layout_.has_value(); }

  private:
    Eigen::Vector3d point_ = Eigen::Vector3d::Zero();
    std::optional<mvs::Layout> layout_;
    Eigen::Vector2d centre_ = Eigen::Vector2d::Zero();
};

}  // namespace suture::tube

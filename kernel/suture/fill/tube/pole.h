#pragma once

#include "suture/base/result.h"
#include "suture/model/ribbon.h"

#include <Eigen/Core>

#include <optional>
#include <vector>

namespace suture::tube {

/// A closing point and the unit normal there.
struct Pole {
    Eigen::Vector3d point, normal;
};

/// Where the tube closes: points and normals that were given are kept; else the point lies where
/// circular arcs that leave the sides tangentially meet on the average, and the normal is that of
/// the plane in which they arrive, so that windows in spheres get a point of the sphere.
///
/// Refuses  a point from which a side is not seen from inside: the hole is not star-shaped there.
[[nodiscard]] Result<Pole> find_pole(const RibbonLoop& loop, double diameter,
                                     const std::optional<Eigen::Vector3d>& point,
                                     const std::optional<Eigen::Vector3d>& normal);

/// The outward radial direction at a border point: the unit projection of point - pole on the
/// neighbour's tangent plane.
[[nodiscard]] Eigen::Vector3d radial(const RibbonPoint& at, const Eigen::Vector3d& pole);

/// Unit directions in the tangent plane of the pole, one for each column, in which the columns
/// leave it: the projections of the border's tangents d_j, or of c_j - pole, whichever turn around
/// the normal once without turning back.
///
/// Input    mirrored columns (at double knots) may have any direction.
/// Refuses  if neither does.
[[nodiscard]] Result<std::vector<Eigen::Vector3d>> directions_at(const Pole& pole,
                                                                 const Eigen::Matrix3Xd& border,
                                                                 const Eigen::Matrix3Xd& tangents);

}  // namespace suture::tube

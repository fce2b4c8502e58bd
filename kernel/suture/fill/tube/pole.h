#pragma once

#include "suture/base/result.h"
#include "suture/fill/tube/radials.h"
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
/// circular arcs that leave the border along the radials and end parallel to the pole's plane come
/// nearest to each other, and the normal is that of the plane in which they arrive. Windows in
/// spheres so get a point of the sphere.
///
/// Refuses  arcs that arrive from no side in particular.
[[nodiscard]] Result<Pole> find_pole(const RibbonLoop& loop, const Radials& radials,
                                     const std::optional<Eigen::Vector3d>& point,
                                     const std::optional<Eigen::Vector3d>& normal);

/// Unit directions in the pole's plane, one for each column, in which the columns leave it. From a
/// given point these are the projections of the border's tangents d_j, or of c_j - pole if those
/// turn back somewhere; from a layout its own directions, turned as the border's tangents want.
///
/// Input    plane: the columns in the layout, 2 x columns; empty if there is none.
/// Refuses  directions that do not go around the normal once without turning back.
[[nodiscard]] Result<std::vector<Eigen::Vector3d>> directions_at(const Pole& pole,
                                                                 const Eigen::Matrix3Xd& border,
                                                                 const Eigen::Matrix3Xd& tangents,
                                                                 const Eigen::Matrix2Xd& plane);

}  // namespace suture::tube

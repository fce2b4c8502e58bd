#pragma once

#include "suture/model/surface.h"

#include <Eigen/Core>

#include <vector>

namespace suture::recognise {

/// The signed distance of a point from a closed form, and its gradient, the form's unit normal at
/// the foot: away from the axis or centre, along z of a plane.
struct Distance {
    double value = 0.0;
    Eigen::Vector3d normal = Eigen::Vector3d::Zero();
};

/// Not for B-splines (ContractViolation).
[[nodiscard]] Distance distance_to(const Surface& form, const Eigen::Vector3d& point);

/// The lengths and angles of a form, in the order of its definition: radius; radius, half_angle;
/// major, minor.
[[nodiscard]] std::vector<double*> sizes_of(Surface& form);

/// Whether it is one of the five with formulas: no B-spline.
[[nodiscard]] inline bool closed_form(const Surface& surface) {
    return !std::holds_alternative<SplineSurface>(surface);
}

[[nodiscard]] Frame& frame_of(Surface& form);
[[nodiscard]] const Frame& frame_of(const Surface& form);

/// A right-handed frame with this axis.
[[nodiscard]] Frame frame_along(const Eigen::Vector3d& origin, const Eigen::Vector3d& z);

/// Whether it is a surface that CAD systems draw: positive radii, a torus that is no
/// sphere, a cone that is neither a cylinder nor a plane.
[[nodiscard]] bool sensible(const Surface& form);

/// The number of its parameters: plane 3, sphere 4, cylinder 5, cone 6, torus 7.
[[nodiscard]] int complexity(const Surface& form);

}  // namespace suture::recognise

#pragma once

#include "suture/base/result.h"
#include "suture/fill/algebraic/polynomial.h"
#include "suture/model/ribbon.h"

#include <Eigen/Core>

namespace suture::algebraic {

/// The coordinates that the method computes in: x = origin + size y with the hole about as large
/// as the unit ball, so that coefficients of all degrees weigh alike.
struct Unit {
    Eigen::Vector3d origin = Eigen::Vector3d::Zero();
    double size = 1.0;

    [[nodiscard]] Eigen::Vector3d in(const Eigen::Vector3d& x) const { return (x - origin) / size; }
    [[nodiscard]] Eigen::Vector3d out(const Eigen::Vector3d& y) const { return origin + size * y; }
};

/// The neighbour's surface as f = 0 in unit coordinates, with a gradient of length 1 along the
/// outward normal in the middle of the ribbon. Planes, cylinders, cones, spheres, tori, and
/// B-splines that are planes or quadrics.
///
/// Input    distance: how far a B-spline's points may lie from the quadric, in model units.
/// Refuses  a neighbour without such an equation, naming the ribbon.
[[nodiscard]] Result<Polynomial<double>> implicit_form(const Ribbon& ribbon, const Unit& unit,
                                                       double distance);

/// How a side lies in space.
struct SideShape {
    bool straight = false;
    Polynomial<double> plane;  ///< in unit coordinates with a normal of length 1; unless straight
};

/// The plane of a ribbon's curve.
///
/// Input    distance: how far its points may leave the plane, or a straight line, in model units.
/// Refuses  a curve that is not planar, with how far it leaves its best plane.
[[nodiscard]] Result<SideShape> shape_of(const Ribbon& ribbon, const Unit& unit, double distance);

}  // namespace suture::algebraic

#pragma once

#include "suture/fill/algebraic/polynomial.h"
#include "suture/model/ribbon.h"

#include <Eigen/Core>

#include <optional>

namespace suture::algebraic {

/// The coordinates that the method computes in: x = origin + size y with the hole about as large
/// as the unit ball, so that coefficients of all degrees weigh alike.
struct Unit {
    Eigen::Vector3d origin = Eigen::Vector3d::Zero();
    double size = 1.0;

    [[nodiscard]] Eigen::Vector3d in(const Eigen::Vector3d& x) const { return (x - origin) / size; }
    [[nodiscard]] Eigen::Vector3d out(const Eigen::Vector3d& y) const { return origin + size * y; }
};

/// The neighbour's own surface as f = 0 in unit coordinates, if it is a plane, cylinder, cone,
/// sphere or torus; the gradient points along the outward normal in the middle of the ribbon.
[[nodiscard]] std::optional<Polynomial<double>> equation_of(const Ribbon& ribbon, const Unit& unit);

/// How a side lies in space.
struct SideShape {
    bool straight = false;
    /// Of a bent side that is planar: in unit coordinates with a normal of length 1.
    std::optional<Polynomial<double>> plane;
};

/// Input    distance: how far its points may leave a plane, or a straight line, in model units.
[[nodiscard]] SideShape shape_of(const Ribbon& ribbon, const Unit& unit, double distance);

}  // namespace suture::algebraic

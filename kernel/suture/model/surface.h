#pragma once

#include "suture/spline/surface.h"

#include <Eigen/Core>

#include <string_view>
#include <variant>

namespace suture {

/// A right-handed orthonormal frame.
struct Frame {
    Eigen::Vector3d origin = Eigen::Vector3d::Zero();
    Eigen::Vector3d x = Eigen::Vector3d::UnitX();
    Eigen::Vector3d y = Eigen::Vector3d::UnitY();
    Eigen::Vector3d z = Eigen::Vector3d::UnitZ();
};

/// The surfaces of CAD in closed form, parametrised as in STEP (ISO 10303-42): with c = cos u,
/// s = sin u and e = c x + s y,
///   plane     origin + u x + v y
///   cylinder  origin + radius e + v z
///   cone      origin + (radius + v sin(half_angle)) e + v cos(half_angle) z
///   sphere    origin + radius (cos v e + sin v z)
///   torus     origin + (major + minor cos v) e + minor sin v z
struct Plane {
    Frame frame;
};
struct Cylinder {
    Frame frame;
    double radius = 1.0;
};
struct Cone {
    Frame frame;
    double radius = 1.0;      ///< at the frame's origin
    double half_angle = 0.5;  ///< between the axis and the generators, in radians
};
struct Sphere {
    Frame frame;
    double radius = 1.0;
};
struct Torus {
    Frame frame;
    double major = 2.0;
    double minor = 1.0;
};

using Surface = std::variant<Plane, Cylinder, Cone, Sphere, Torus, SplineSurface>;

/// "plane", "cylinder", ..., "B-spline surface": for messages.
[[nodiscard]] std::string_view kind_name(const Surface& surface);

/// Whether u (v) is an angle, so that u and u + 2 pi are the same point.
[[nodiscard]] bool periodic_u(const Surface& surface);
[[nodiscard]] bool periodic_v(const Surface& surface);

/// Point and derivatives up to order two at the surface's own parameters.
[[nodiscard]] SurfaceJet evaluate(const Surface& surface, double u, double v);

/// The parameters of the point of a closed form nearest to a given one, by formula; angles in
/// (-pi, pi], the sphere's v in [-pi/2, pi/2]. Not for B-splines (ContractViolation).
[[nodiscard]] Eigen::Vector2d parameters_of(const Surface& surface, const Eigen::Vector3d& point);

/// Whether both are the same point set, so that one continues the other.
///
/// Input    distance: how far points of one may lie from the other, in model units, within `reach`
///          of the origin of `near`; angles are compared so that they cause no more than that.
/// Result   always false between surfaces of different kinds. B-splines must agree pole by pole.
[[nodiscard]] bool same_surface(const Surface& a, const Surface& b, const Eigen::Vector3d& near,
                                double reach, double distance);

}  // namespace suture

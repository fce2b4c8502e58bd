#pragma once

#include "suture/base/result.h"
#include "suture/model/surface.h"
#include "suture/occ/handle.h"
#include "suture/spline/curve.h"

#include <Eigen/Core>

#include <Geom_Curve.hxx>
#include <Geom_Surface.hxx>
#include <gp_Ax3.hxx>
#include <gp_Pnt.hxx>
#include <gp_Pnt2d.hxx>
#include <gp_Vec.hxx>

#include <optional>

namespace suture::occ {

inline Eigen::Vector3d from_occ(const gp_Pnt& p) {
    return {p.X(), p.Y(), p.Z()};
}
inline Eigen::Vector3d from_occ(const gp_Vec& v) {
    return {v.X(), v.Y(), v.Z()};
}
inline Eigen::Vector3d from_occ(const gp_Dir& d) {
    return {d.X(), d.Y(), d.Z()};
}
inline Eigen::Vector2d from_occ(const gp_Pnt2d& p) {
    return {p.X(), p.Y()};
}
inline gp_Pnt to_point(const Eigen::Vector3d& p) {
    return {p.x(), p.y(), p.z()};
}
inline gp_Dir to_direction(const Eigen::Vector3d& d) {
    return {d.x(), d.y(), d.z()};
}
inline gp_Pnt2d to_point(const Eigen::Vector2d& p) {
    return {p.x(), p.y()};
}

/// The exact OCCT surface. Knots that repeat become multiplicities.
///
/// Refuses  a B-spline of a degree above OCCT's 25.
[[nodiscard]] Result<Handle<Geom_Surface>> to_occ(const Surface& surface);

/// The closed form of an OCCT surface, and how its parameters map to ours.
struct ClosedForm {
    Surface surface;
    /// our (u, v) = sign * OCCT's (u, v), by component: our frames are right-handed
    Eigen::Vector2d sign = Eigen::Vector2d::Ones();
};

/// Plane, cylinder, cone, sphere, torus, B-spline, Bezier, and trimmed ones of these; nothing for
/// offsets, extrusions and revolutions.
[[nodiscard]] std::optional<ClosedForm> from_occ(const Handle<Geom_Surface>& surface);

/// A curve's part from one parameter to another, backwards if need be, as a polynomial on [0,1]:
/// of lines, polynomial Bezier curves and B-splines; nothing for others.
[[nodiscard]] std::optional<SplineCurve> spline_of(const Handle<Geom_Curve>& curve, double from,
                                                   double to);

}  // namespace suture::occ

#pragma once

#include <Geom_Surface.hxx>
#include <gp_Ax3.hxx>
#include <gp_Pnt.hxx>
#include <gp_Pnt2d.hxx>
#include <gp_Vec.hxx>

#include <Eigen/Core>
#include <optional>

#include "suture/base/result.h"
#include "suture/model/surface.h"
#include "suture/occ/handle.h"

namespace suture::occ {

inline Eigen::Vector3d from_occ(const gp_Pnt& p) { return {p.X(), p.Y(), p.Z()}; }
inline Eigen::Vector3d from_occ(const gp_Vec& v) { return {v.X(), v.Y(), v.Z()}; }
inline Eigen::Vector3d from_occ(const gp_Dir& d) { return {d.X(), d.Y(), d.Z()}; }
inline Eigen::Vector2d from_occ(const gp_Pnt2d& p) { return {p.X(), p.Y()}; }
inline gp_Pnt to_point(const Eigen::Vector3d& p) { return {p.x(), p.y(), p.z()}; }
inline gp_Dir to_direction(const Eigen::Vector3d& d) { return {d.x(), d.y(), d.z()}; }
inline gp_Pnt2d to_point(const Eigen::Vector2d& p) { return {p.x(), p.y()}; }

/// The exact OCCT surface. Knots that repeat become multiplicities.
///
/// Refuses  a B-spline of a degree above OCCT's 25.
[[nodiscard]] Result<Handle<Geom_Surface>> to_occ(const Surface& surface);

/// The closed form of an OCCT surface, and how its parameters map to ours.
struct ClosedForm {
    Surface surface;
    /// our u = u_sign * OCCT's u, since our frames are right-handed
    double u_sign = 1.0;
};

/// Plane, cylinder, cone, sphere, torus, and every surface that is a B-spline or a Bezier patch or
/// a trimmed one of these; nothing for offsets, extrusions and revolutions of other curves.
[[nodiscard]] std::optional<ClosedForm> from_occ(const Handle<Geom_Surface>& surface);

}  // namespace suture::occ

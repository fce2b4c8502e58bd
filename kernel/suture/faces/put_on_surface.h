#pragma once

#include "suture/faces/placement.h"
#include "suture/occ/handle.h"

#include <Eigen/Core>

#include <Geom_Surface.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Vertex.hxx>
#include <gp_Pnt.hxx>

#include <functional>

namespace suture {

/// How far an edge's curve lies from a surface, and what that asked for.
struct Placed {
    double gap = 0.0;        ///< largest distance, model units
    double tolerance = 0.0;  ///< the edge's new tolerance, 0 if the old one was large enough
};

/// Where a pcurve that was laid out begins and ends.
enum class Ends {
    Laid,  ///< in the layout's corners, on which other curves of the surface rely
    Feet,  ///< in the feet of the edge's vertices, which neighbouring edges share
};

/// An edge's curve on a further surface. It stands at the edge's own feet on the surface, so that
/// the distance at one parameter is the gap and nothing else. Changes nothing.
///
/// Input    at: about where that is, (u, v) at the edge's parameter t; accuracy: of the pcurve,
///          model units.
[[nodiscard]] Placement place_on_surface(const TopoDS_Edge& edge,
                                         const occ::Handle<Geom_Surface>& surface,
                                         const std::function<Eigen::Vector2d(double t)>& at,
                                         Ends ends, double accuracy);

/// Gives an edge its curve on a further surface. The tolerances of the edge and its vertices grow
/// where the gap needs it.
[[nodiscard]] Placed put_on_surface(const TopoDS_Edge& edge,
                                    const occ::Handle<Geom_Surface>& surface,
                                    const Placement& placement);

/// The same for an edge that the surface meets twice, a seam.
///
/// Input    forward, reversed: where the face uses the edge in that orientation.
[[nodiscard]] Placed put_on_surface_twice(const TopoDS_Edge& edge,
                                          const occ::Handle<Geom_Surface>& surface,
                                          const Placement& forward, const Placement& reversed);

/// The vertex's tolerance grows if it does not cover the point.
void reach(const TopoDS_Vertex& vertex, const gp_Pnt& point);

}  // namespace suture

#pragma once

#include "suture/occ/handle.h"

#include <Geom2d_Curve.hxx>
#include <Geom_Curve.hxx>
#include <TopLoc_Location.hxx>
#include <TopoDS_Edge.hxx>
#include <gp_Pnt.hxx>

#include <array>

namespace suture {

/// Where an edge lies on a further surface.
struct Placement {
    occ::Handle<Geom2d_Curve> pcurve;  ///< null on a plane, which needs none
    double gap = 0.0;                  ///< largest distance of the edge to the surface, model units
    double reach =
        0.0;  ///< largest distance to the pcurve's image: what the tolerance has to cover

    /// Of the edge that this was found for: its curve, where that is, and its vertices from start
    /// to end.
    occ::Handle<Geom_Curve> curve;
    TopLoc_Location location;
    std::array<gp_Pnt, 2> ends;

    /// Whether it holds for another edge: one with the same curve between the same points.
    [[nodiscard]] bool holds_for(const TopoDS_Edge& edge) const;
};

/// What was found for an edge. Input as in Placement.
[[nodiscard]] Placement placement_of(const TopoDS_Edge& edge,
                                     const occ::Handle<Geom2d_Curve>& pcurve, double gap,
                                     double reach);

}  // namespace suture

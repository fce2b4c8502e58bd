#pragma once

#include "suture/occ/handle.h"

#include <Geom2d_Curve.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>

#include <optional>

namespace suture {

/// A part of an edge as a face uses it.
struct EdgePart {
    TopoDS_Edge edge;  ///< oriented as the face uses it
    TopoDS_Face face;  ///< oriented as in the shape
    double first = 0.0;
    double last = 0.0;
};

/// Gives the kept edge a pcurve on the other's face.
///
/// Input    common: a forward edge with the curve, the range and the pcurves of `kept`, changed in
///          place; same_way: the curves of `kept` and `gone` run the same way; gap: between these.
/// Result   the largest distance of the curve on the other's face from the edge, or nothing: the
///          two faces lie on one surface and both use it the same way.
[[nodiscard]] std::optional<double> add_other_face(const EdgePart& kept, const EdgePart& gone,
                                                   bool same_way, double gap, TopoDS_Edge& common);

}  // namespace suture

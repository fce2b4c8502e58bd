#pragma once

#include "suture/check/continuity.h"
#include "suture/check/edge_uses.h"

#include <BRepAdaptor_Curve.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>

#include <array>

namespace suture {

/// Measures one edge between the faces of its two uses; fills everything of EdgeContinuity but the
/// numbers and the class. Raises what OCCT raises on an edge without any curve.
[[nodiscard]] EdgeContinuity measure_edge(const TopoDS_Edge& edge,
                                          const std::array<TopoDS_Face, 2>& faces,
                                          const std::array<EdgeInFace, 2>& uses);

/// The length of an edge. Not of the edge's adaptor alone: GCPnts takes a line's length from its
/// parameters, which is wrong under a location that scales.
[[nodiscard]] double length_of(const TopoDS_Edge& edge, const BRepAdaptor_Curve& adaptor);

}  // namespace suture

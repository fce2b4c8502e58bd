#pragma once

#include "suture/check/measure_edge.h"

namespace suture {

/// Measures how a face stands on another one's surface along an edge, which that one need not have:
/// the angle and the curvature between them.
///
/// Input    edge, face, use: the edge as the face uses it; support: a face along whose surface the
///          edge runs. Which way it is oriented counts for nothing.
/// Result   as of measure_edge; the gap is that between the face and the support's surface.
///          Raises what OCCT raises.
[[nodiscard]] EdgeContinuity measure_support(const TopoDS_Edge& edge, const TopoDS_Face& face,
                                             const EdgeInFace& use, const TopoDS_Face& support);

}  // namespace suture

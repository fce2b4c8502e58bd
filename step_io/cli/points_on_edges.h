#pragma once

#include "suture/base/result.h"
#include "suture/base/through_point.h"

#include <TopoDS_Shape.hxx>

#include <utility>
#include <vector>

namespace suture::cli {

/// Points of edges at equal parameters, ends included: as many as bend a face along them.
///
/// Input    edges: EdgeN, each with FaceN, whose normals the points take, or 0; reach: how far an
///          edge may be from its face, model units.
/// Refuses  (Usage) an edge or a face that does not exist; an edge without length; a face that its
///          edge does not lie on.
[[nodiscard]] Result<std::vector<ThroughPoint>> points_on_edges(
    const TopoDS_Shape& model, const std::vector<std::pair<int, int>>& edges, double reach);

}  // namespace suture::cli

#pragma once

#include "suture/detect/boundary_loop.h"

#include <Eigen/Core>

#include <TopoDS_Edge.hxx>

#include <utility>

namespace suture {

/// Point and direction where the edge, as it is oriented, is walked to the part s of its range.
[[nodiscard]] std::pair<Eigen::Vector3d, Eigen::Vector3d> walk_to(const TopoDS_Edge& edge,
                                                                  double s);

/// Twice the area that a loop encloses, along the side from which it runs counterclockwise.
[[nodiscard]] Eigen::Vector3d area_of(const BoundaryLoop& loop);

/// The side walked the other way, its face turned over.
[[nodiscard]] BoundaryEdge turned(BoundaryEdge side);

/// Changes  loop: its length and its diameter, from its edges.
void measure_size(BoundaryLoop& loop);

}  // namespace suture

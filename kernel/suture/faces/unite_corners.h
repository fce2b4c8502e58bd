#pragma once

#include "suture/detect/boundary_loop.h"

#include <TopoDS_Shape.hxx>

#include <vector>

namespace suture {

/// Where an edge of a loop ends and the next one begins in another vertex at the same place, both
/// edges and all others of the shape there get one vertex: no wire is closed without. The same
/// place is within the vertices' tolerances or the loop's corner_reach.
///
/// Changes  the shape in place: faces and edges stay the same objects.
void unite_corners(const TopoDS_Shape& shape, const std::vector<BoundaryLoop>& loops);

}  // namespace suture

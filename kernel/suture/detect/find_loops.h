#pragma once

#include "suture/base/result.h"
#include "suture/detect/boundary_loop.h"
#include "suture/occ/topology.h"

#include <TopoDS_Shape.hxx>

#include <vector>

namespace suture {

/// All boundary loops of every shell of a shape, classified.
///
/// Input    shape: a compound, solid, shell or face; loose faces already sewn (see
/// sew/sew_shape.h);
///          numbering: the model's, which the shape is part of.
/// Result   loops ordered by their smallest edge number; seam edges and degenerated edges are no
///          free edges; loops that touch in a vertex are separated.
/// Source   docs/holes.md states the rules of the classification and the limits they use.
[[nodiscard]] Result<std::vector<BoundaryLoop>> find_loops(const TopoDS_Shape& shape,
                                                           const occ::Numbering& numbering);

}  // namespace suture

#pragma once

#include "suture/base/result.h"
#include "suture/detect/boundary_loop.h"
#include "suture/fill/fill.h"
#include "suture/model/ribbon.h"
#include "suture/occ/topology.h"

#include <TopoDS_Shape.hxx>

#include <vector>

namespace suture {

/// Where surfaces of a lost face are looked for.
enum class Scope {
    Neighbours,  ///< on the surfaces around the hole
    Model        ///< on those of all faces, on their offsets, and on congruent faces
};

/// Surfaces of the model on which a hole's lost face may lie, the most certain first: those that
/// hold the whole border (also where the sides on them are sharp), those at a constant distance
/// from it, and those of faces whose border is congruent to the hole's.
///
/// Input    model: the part that the hole is in; numbering: of the model that it is part of.
[[nodiscard]] Result<std::vector<Candidate>> find_candidates(const TopoDS_Shape& model,
                                                             const occ::Numbering& numbering,
                                                             const std::vector<BoundaryLoop>& loops,
                                                             const Hole& hole, Scope scope);

}  // namespace suture

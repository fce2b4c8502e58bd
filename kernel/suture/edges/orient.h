#pragma once

#include "suture/detect/boundary_loop.h"

#include <vector>

namespace suture {

/// Begins a loop at its edge of the smallest number; a curve that was made comes behind all others.
void begin_at_smallest(BoundaryLoop& loop);

/// Loops without any face are walked as the others want it: islands against the outer one.
///
/// Changes  loops: those of one face, the longest first.
void orient_free_loops(std::vector<BoundaryLoop>& loops);

}  // namespace suture

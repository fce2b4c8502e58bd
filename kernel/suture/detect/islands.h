#pragma once

#include "suture/detect/boundary_loop.h"
#include "suture/detect/loop_shape.h"

#include <vector>

namespace suture {

/// Finds the loops that together bound one missing face: nested loops of one plane, and two circles
/// about one axis whose neighbours go on to each other (docs/holes.md). Changes `islands_with`,
/// `kind` and `reason`.
///
/// Input  component: per loop, the shell that it bounds; solid: per loop, the number of the solid
///        that this shell lies in, 0: in none; all go with `loops`.
void find_islands(std::vector<BoundaryLoop>& loops, const std::vector<LoopShape>& shapes,
                  const std::vector<int>& component, const std::vector<int>& solid);

}  // namespace suture

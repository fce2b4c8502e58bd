#pragma once

#include "suture/detect/boundary_loop.h"
#include "suture/model/ribbon.h"

#include <vector>

namespace suture {

/// How exact a model is around a hole: the largest distance of its edges' own curves from the
/// neighbours' surfaces, in model units. Files state much larger tolerances than they need.
///
/// Input    hole: of these loops.
[[nodiscard]] double measure_noise(const std::vector<BoundaryLoop>& loops, const Hole& hole);

/// The same side by side, loop by loop.
[[nodiscard]] std::vector<double> noise_of_sides(const std::vector<BoundaryLoop>& loops,
                                                 const Hole& hole);

}  // namespace suture

#pragma once

#include "suture/detect/boundary_loop.h"
#include "suture/detect/loop_shape.h"
#include "suture/model/surface.h"

#include <optional>
#include <utility>
#include <vector>

namespace suture {

/// The closed form that all neighbours of a loop share; nothing: they share none.
[[nodiscard]] std::optional<Surface> common_surface(const BoundaryLoop& loop,
                                                    const LoopShape& shape);

/// Whether the loops' common surfaces are one.
[[nodiscard]] bool on_one_surface(const std::optional<Surface>& a, const std::optional<Surface>& b,
                                  const LoopShape& shape);

/// Pairs of loops between which a band of one surface is missing: both go once around it, the one
/// with the hole above and the other with the hole below, and nothing lies between them.
///
/// Input   surfaces: common_surface of each loop, nothing for loops that are out of the question.
[[nodiscard]] std::vector<std::pair<int, int>> find_surface_bands(
    const std::vector<std::optional<Surface>>& surfaces, const std::vector<LoopShape>& shapes);

}  // namespace suture

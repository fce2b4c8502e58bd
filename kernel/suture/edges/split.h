#pragma once

#include "suture/base/result.h"
#include "suture/detect/boundary_loop.h"

#include <Eigen/Core>

#include <optional>
#include <utility>
#include <vector>

namespace suture {

/// Two corners of a loop, by the edges that begin there.
using CornerPair = std::pair<std::size_t, std::size_t>;

/// The two corners where a loop lies nearest to given points.
///
/// Result   none: a point is farther than `reach` from every corner, or both are the same one.
[[nodiscard]] std::optional<CornerPair> corners_at(const BoundaryLoop& loop,
                                                   const Eigen::Vector3d& one,
                                                   const Eigen::Vector3d& other, double reach);

/// Where a loop is to be cut so that two faces close it better than one: between two sharp turns,
/// if both parts lie far nearer to a plane than the whole does (the deck and the transom of a
/// hull).
[[nodiscard]] std::optional<CornerPair> find_split(const BoundaryLoop& loop);

/// Cuts a loop in two along a new straight edge between two of its corners. The first part has the
/// loop's id, the second one has none.
///
/// Refuses  (Usage) corners that are neighbours joined by a straight side, for nothing is between.
[[nodiscard]] Result<std::pair<BoundaryLoop, BoundaryLoop>> split_loop(const BoundaryLoop& loop,
                                                                       const CornerPair& corners);

}  // namespace suture

#pragma once

#include "suture/base/result.h"
#include "suture/choose/report.h"
#include "suture/choose/request.h"
#include "suture/detect/boundary_loop.h"

#include <vector>

namespace suture {

/// What is to be filled, and why the rest is not.
struct Selection {
    std::vector<std::vector<BoundaryLoop>>
        holes;  ///< each one missing face: the longest loop first
    std::vector<HoleReport> skipped;
};

/// Picks the loops that a request means: the named ones, those that hold named edges, or every
/// hole; with all_loops rims and ambiguous loops as well. Seams and slits are never filled unasked.
///
/// Refuses  (Usage) ids and edges that do not exist; (NothingToDo) when nothing is left.
[[nodiscard]] Result<Selection> select_holes(const std::vector<BoundaryLoop>& loops,
                                             const FillRequest& request);

/// The report of a loop that is not filled, and why.
[[nodiscard]] HoleReport skipped_report(const BoundaryLoop& loop);

}  // namespace suture

#pragma once

#include "suture/choose/report.h"
#include "suture/choose/request.h"
#include "suture/faces/placement.h"
#include "suture/flow/plan.h"
#include "suture/model/patch.h"

#include <vector>

namespace suture {

/// The fill that a hole gets, and what became of the search for it.
struct ComputedFill {
    std::vector<BoundaryLoop> loops;
    Hole hole;                          ///< with the continuity that was asked for in the end
    FillResult fill;                    ///< only where report.status is Filled
    std::vector<Placement> placements;  ///< of copies of the hole's edges on its faces
    HoleReport report;  ///< Filled: to be applied; Refused: why, with the figures of the best try
    double seconds_fill = 0.0;    ///< in the fill methods themselves
    double seconds_choose = 0.0;  ///< in these, and in making and judging what each one gave
};

/// Makes and judges candidates for every hole of a plan, on copies: the shape stays as it is.
/// Runs on all cores; the result does not depend on their number.
///
/// Refuses  only a cancelled run. A hole without a fill is refused in its own report, and so is one
///          whose best fill is bad, unless the request says to keep it.
[[nodiscard]] Result<std::vector<ComputedFill>> compute_fills(const TopoDS_Shape& shape,
                                                              const FillPlan& plan,
                                                              const FillRequest& request);

}  // namespace suture

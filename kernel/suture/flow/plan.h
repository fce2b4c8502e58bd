#pragma once

#include "suture/base/result.h"
#include "suture/choose/report.h"
#include "suture/choose/request.h"
#include "suture/choose/wishes.h"
#include "suture/detect/boundary_loop.h"
#include "suture/model/ribbon.h"
#include "suture/occ/topology.h"

#include <TopoDS_Shape.hxx>

#include <vector>

namespace suture {

/// One missing face: what bounds it, and what is wanted of the fill.
struct HolePlan {
    std::vector<BoundaryLoop> loops;  ///< the longest first
    Result<Hole> hole;                ///< its ribbons, or why it has none
    std::vector<Wish> wishes;         ///< side by side, in the order of the loops
    CandidateFinder candidates;  ///< looks in the shape that was planned for; keeps what it found
    std::size_t guides = 0;      ///< so many of the hole's last points only guide a fill
    std::vector<std::string> spoilt;  ///< names of the fills that a file spoils
};

/// What is to be filled, and why the rest is not.
struct FillPlan {
    std::vector<HolePlan> holes;
    std::vector<HoleReport> skipped;
    const occ::Numbering* numbering = nullptr;  ///< as given
};

/// Looks and decides what is wanted: loops, which of them, ribbons, wishes. Changes nothing.
///
/// Input    numbering: must live as long as the plan.
/// Refuses  unknown methods and options, hole ids and edges that do not exist (Usage); a shape
///          without a hole (NothingToDo).
[[nodiscard]] Result<FillPlan> plan_fills(const TopoDS_Shape& shape,
                                          const occ::Numbering& numbering,
                                          const FillRequest& request);

}  // namespace suture

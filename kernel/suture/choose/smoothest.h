#pragma once

#include "suture/choose/choose.h"
#include "suture/choose/wishes.h"

namespace suture {

/// choose_fill, with G2 where that is hoped for: the fill that has it is kept if gap and angle stay
/// within tolerance all around; else G1 is asked for in its place.
///
/// Changes  hole, wishes: what was hoped for and not reached becomes G1, with the reason.
[[nodiscard]] Result<Choice> choose_smoothest(const std::vector<BoundaryLoop>& loops, Hole& hole,
                                              std::vector<Wish>& wishes, const FillRequest& request,
                                              const Tolerance& tolerance);

}  // namespace suture

#pragma once

#include "suture/choose/choose.h"
#include "suture/choose/wishes.h"

namespace suture {

/// choose_fill, with G2 where that is hoped for: the fill that has it is kept if gap and angle stay
/// within tolerance all around; else G1 is asked for in its place. Where our own methods have no
/// tangent fill, or only one that is sharp along a side, position is asked for: along the sides
/// that stand steeply on the opening or came out sharp, or else along all that are left to us.
///
/// Changes  hole, wishes: what was not reached becomes G1 or G0, with the reason.
[[nodiscard]] Result<Choice> choose_smoothest(const Site& site, Hole& hole,
                                              std::vector<Wish>& wishes, const FillRequest& request,
                                              const Tolerance& tolerance);

}  // namespace suture

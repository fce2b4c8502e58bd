#pragma once

#include "suture/choose/twin_figures.h"
#include "suture/choose/wishes.h"
#include "suture/detect/boundary_loop.h"
#include "suture/judge/judge_fill.h"
#include "suture/model/patch.h"
#include "suture/model/ribbon.h"

#include <optional>
#include <vector>

namespace suture {

/// What a fill of a hole is held against: the continuity of its ribbons, how the neighbours meet at
/// its corners, what its edges are good for.
///
/// Input    wishes: which sides have given tangency up; may be empty.
[[nodiscard]] AskedFill asked_of(const std::vector<BoundaryLoop>& loops, const Hole& hole,
                                 const std::vector<Wish>& wishes, const Tolerance& tolerance);

/// Adds what a fill says of itself: that its surfaces have a closed form, that it is the lost
/// surface; and what that one's twin has, if it was measured.
///
/// Changes  asked: closed_form, recognised, twin_folds, the sides' of_twin.
void account_for(const FillResult& fill, bool recognised, const std::optional<TwinFigures>& twin,
                 AskedFill& asked);

}  // namespace suture

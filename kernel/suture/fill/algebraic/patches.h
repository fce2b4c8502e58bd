#pragma once

#include "suture/base/progress.h"
#include "suture/base/result.h"
#include "suture/base/tolerance.h"
#include "suture/fill/algebraic/neighbour.h"
#include "suture/fill/algebraic/solution.h"
#include "suture/model/patch.h"

namespace suture::algebraic {

/// How well the patches represent the algebraic surface.
struct FitReport {
    double distance = 0.0;  ///< largest |g| / |grad g| on a patch, in model units
    double angle = 0.0;     ///< largest angle between a patch's normal and grad g, in radians
    int spans = 0;          ///< most in a direction
};

/// One biquintic B-spline face for each sector, with knots as dense as the tolerance asks for.
///
/// Input    goal: for distance (model units) and angle of each patch; limit: what is taken where
///          kMostSpans spans do not meet the goal.
/// Refuses  a sheet that does not reach over a whole sector, or whose patch folds; one beyond the
///          limit.
[[nodiscard]] Result<FillResult> make_patches(const Problem& problem, const Solution& solution,
                                              const Unit& unit, const Tolerance& goal,
                                              const Tolerance& limit, const Progress& progress,
                                              FitReport& report);

}  // namespace suture::algebraic

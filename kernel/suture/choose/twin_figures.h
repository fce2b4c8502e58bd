#pragma once

#include "suture/base/progress.h"
#include "suture/choose/trial.h"
#include "suture/judge/judge_fill.h"
#include "suture/model/recognised.h"
#include "suture/model/ribbon.h"

#include <optional>
#include <vector>

namespace suture {

/// What is measured of a face of the model that is congruent to a lost one.
struct TwinFigures {
    /// How it meets its own neighbours where it lies as the sides of the hole do, in their order;
    /// nothing where it has none, or no edge.
    std::vector<std::optional<AngleRange>> angles;
    bool folds = false;
};

/// Measures the face of which a fill is a copy, in the model, by the code that measures fills.
///
/// Result   nothing where it cannot be measured: then it excuses nothing.
[[nodiscard]] std::optional<TwinFigures> measure_twin(const Site& site, const Hole& hole,
                                                      const TwinSource& source,
                                                      const Progress& progress);

}  // namespace suture

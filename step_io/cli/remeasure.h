#pragma once

#include "cli/load.h"
#include "suture/base/progress.h"
#include "suture/fill_holes.h"

#include <string>
#include <vector>

namespace suture::cli {

/// A part and what became of it.
struct FilledPart {
    const PartLoops* before = nullptr;
    FillOutcome outcome;
};

/// Measures the filled holes once more, on another copy of the model, as it is after writing and
/// reading say: the new faces are found again by their vertices, area and centroid, the sides by
/// length and centroid, because the order of a file is not that of the model.
///
/// Result   the figures, the verdict and the face numbers in parts[].outcome.holes are those of
///          `shape`; a side that is not found again has no figures, and a finding says so.
[[nodiscard]] Result<void> remeasure(const TopoDS_Shape& shape, std::vector<FilledPart>& parts,
                                     const Tolerance& tolerance, const Progress& progress);

/// Sets the face numbers in parts[].outcome.holes to those of the model in memory.
void number_new_faces(const TopoDS_Shape& model, std::vector<FilledPart>& parts);

}  // namespace suture::cli

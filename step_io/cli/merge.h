#pragma once

#include "cli/load.h"
#include "cli/remeasure.h"
#include "suture/base/progress.h"
#include "suture/base/result.h"

#include <string>
#include <vector>

namespace suture::cli {

/// Makes the new faces of a filled model one with neighbours that lie on the same surface. Nothing
/// is changed where the result would be worse: not valid, open, of another area.
///
/// Changes  model.file; of parts, the shapes, the new faces, and the notes of the holes.
/// Result   what came of it, a sentence each; model.file is as before if `merged` is false.
struct MergeOutcome {
    bool merged = false;
    std::vector<std::string> said;
};
[[nodiscard]] Result<MergeOutcome> merge_new_faces(LoadedModel& model,
                                                   std::vector<FilledPart>& parts,
                                                   const Progress& progress);

}  // namespace suture::cli

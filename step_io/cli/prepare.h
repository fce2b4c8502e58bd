#pragma once

#include "cli/fill_model.h"
#include "cli/load.h"

namespace suture::cli {

/// Brings a model into the form in which what was asked for is a hole of one part: parts and curves
/// that a chosen boundary runs along become one part; faces that are to go are gone, with what
/// bounded them as boundaries in request, or with their neighbours grown together.
///
/// Changes  model.file, model.changes; model.whole, whose numbers the user knows, stays. request:
///          its boundaries.
/// Refuses  (Usage) edges and faces that do not exist, all faces at once.
[[nodiscard]] Result<void> prepare_model(Run& run, LoadedModel& model, const FillSettings& settings,
                                         FillRequest& request);

/// Up to how far apart the ends of chosen edges are one corner: as far as edges are sewn, and no
/// less than a gap may be wide.
[[nodiscard]] double corner_reach(const LoadedModel& model, const LoadOptions& options,
                                  const Tolerance& tolerance);

}  // namespace suture::cli

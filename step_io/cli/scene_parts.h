#pragma once

#include "cli/fill_model.h"
#include "cli/load.h"

#include "report/scene.h"

namespace suture::cli {

/// The assembly tree for the page, with the numbers of its faces and edges in the whole model.
[[nodiscard]] std::vector<report::ScenePart> scene_parts(const io::ModelFile& model);

/// The boundary loops of a model for the page.
[[nodiscard]] std::vector<report::SceneHole> scene_holes(const std::vector<PartLoops>& parts);

/// What became of the holes of a fill; edges are those of the model before it.
[[nodiscard]] std::vector<report::SceneHole> scene_holes(const FillSummary& summary);

}  // namespace suture::cli

#pragma once

#include <filesystem>

#include "files/model_file.h"
#include "suture/base/result.h"

namespace suture::io {

struct MeshOptions {
    double deflection = 0.0;           ///< model units; 0: a thousandth of the model's diagonal
    double angular_deflection = 0.35;  ///< radians between neighbouring facets
};

/// Writes a model to a temporary file beside `file` and renames it: there is the whole new file or
/// the old one, never half of one.
///
/// STEP keeps the schema and the unit of the input when that was STEP; AP214 and mm otherwise.
/// Meshes (STL binary, OFF, OBJ, 3MF) are watertight: neighbouring faces share their edge points.
/// Refuses  (WriteFailed) a missing folder, no permission, a full disk.
[[nodiscard]] Result<void> write_model(const ModelFile& model, const std::filesystem::path& file,
                                       Format format, const MeshOptions& mesh);

}  // namespace suture::io

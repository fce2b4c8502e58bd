#pragma once

#include "files/mesh.h"
#include "files/model_file.h"
#include "files/step_scan.h"
#include "suture/base/result.h"

#include <TopoDS_Face.hxx>

#include <filesystem>
#include <span>
#include <vector>

namespace suture::io {

/// Writes a model to a temporary file beside `file` and renames it: there is the whole new file or
/// the old one, never half of one.
///
/// STEP keeps the schema and the unit of the input when that was STEP; AP214 and mm otherwise.
/// Meshes (STL binary, OFF, OBJ, 3MF) are watertight: neighbouring faces share their edge points.
/// Result   for STEP, the entity numbers of the faces in `traced` (0: not known); else nothing.
/// Refuses  (WriteFailed) a missing folder, no permission, a full disk.
[[nodiscard]] Result<std::vector<StepId>> write_model(const ModelFile& model,
                                                      const std::filesystem::path& file,
                                                      Format format, const MeshOptions& mesh,
                                                      std::span<const TopoDS_Face> traced = {});

}  // namespace suture::io

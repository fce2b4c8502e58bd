#pragma once

#include "files/mesh.h"
#include "files/model_file.h"
#include "files/step_scan.h"
#include "suture/base/progress.h"
#include "suture/base/result.h"

#include <TopoDS_Face.hxx>

#include <filesystem>
#include <functional>
#include <span>
#include <vector>

namespace suture::io {

/// Reads what is about to become `file`.
///
/// Refuses  (Internal) what cannot be read again.
[[nodiscard]] Result<ModelFile> read_again(const std::filesystem::path& written,
                                           const std::filesystem::path& file,
                                           const Progress& progress);

/// Looks at a file before it takes the place of the old one.
///
/// Input    written: where it can be read from; numbers: as write_model returns them.
using Verify = std::function<Result<void>(const std::filesystem::path& written,
                                          const std::vector<StepId>& numbers)>;

/// Writes a model to a temporary file beside `file`, reads it again, and renames it: there is the
/// whole new file or the old one, never half of one, and never one that cannot be read.
///
/// Input    verify: instead of reading all of it again. Meshes are not read again.
/// STEP keeps the schema and the unit of the input when that was STEP; AP214 and mm otherwise.
/// Meshes (STL binary, OFF, OBJ, 3MF) are watertight: neighbouring faces share their edge points.
/// OBJ, 3MF and glTF keep parts, names and colours, 3MF and glTF the assembly tree too.
/// Result   for STEP, the entity numbers of the faces in `traced` (0: not known); else nothing.
/// Refuses  (WriteFailed) a missing folder, no permission, a full disk; (Internal) a model that
///          cannot be read again; what verify refuses.
[[nodiscard]] Result<std::vector<StepId>> write_model(const ModelFile& model,
                                                      const std::filesystem::path& file,
                                                      Format format, const MeshOptions& mesh,
                                                      std::span<const TopoDS_Face> traced = {},
                                                      const Verify& verify = {});

/// Writes a mesh in the same way. OBJ has a file of materials beside it, if there are colours.
[[nodiscard]] Result<MeshFacts> write_mesh(const ModelFile& model,
                                           const std::filesystem::path& file, Format format,
                                           const MeshOptions& options);

}  // namespace suture::io

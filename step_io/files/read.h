#pragma once

#include "files/model_file.h"
#include "suture/base/progress.h"
#include "suture/base/result.h"

#include <filesystem>

namespace suture::io {

/// Reads STEP, IGES, BREP or FreeCAD's binary BREP; the type is told by the content.
///
/// OCCT's reader can crash or hang on a damaged file. Callers who must survive that run the whole
/// job under supervise() (cli/supervise.h) or in occ::run_isolated.
/// Refuses  (Unreadable) what OCCT cannot read, and a file without any face.
[[nodiscard]] Result<ModelFile> read_model(const std::filesystem::path& file,
                                           const Progress& progress);

}  // namespace suture::io

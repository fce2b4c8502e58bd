#pragma once

#include "files/model_file.h"
#include "suture/base/progress.h"
#include "suture/base/result.h"

#include <string_view>

namespace suture::io {

/// Reads the STEP file model.path, whose text is `text`, into model.document, with its schema,
/// unit, accuracy, origin and the names of missing files.
///
/// Refuses  (Unreadable) a file that is cut off, refers to what it does not hold, or that OCCT
///          cannot read.
[[nodiscard]] Result<void> read_step(ModelFile& model, std::string_view text,
                                     const Progress& progress, bool face_names);

}  // namespace suture::io

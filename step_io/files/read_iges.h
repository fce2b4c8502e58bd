#pragma once

#include "files/model_file.h"
#include "suture/base/progress.h"
#include "suture/base/result.h"

#include <string_view>

namespace suture::io {

/// Reads the IGES file model.path, whose text is `text`, into model.document, with its unit and
/// accuracy. Loose faces become one part.
///
/// Input    place: where OCCT's reader finds the text: the file, or what was unpacked of it
/// Refuses  (Unreadable) a file that is cut off or that OCCT cannot read.
[[nodiscard]] Result<void> read_iges(ModelFile& model, std::string_view text,
                                     const std::filesystem::path& place, const Progress& progress);

}  // namespace suture::io

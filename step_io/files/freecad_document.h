#pragma once

#include "files/model_file.h"
#include "suture/base/result.h"

#include <string>

namespace suture::io {

/// The visible shapes of a FreeCAD document (.FCStd), a part each: bodies, but not the features
/// they are made of; what stands in a group or an App::Part, at its place. Links to other objects
/// are left out, with a note. Colours are not read.
///
/// Input    archive: the file's bytes, a zip archive.
/// Refuses  (Unreadable) a document that cannot be unpacked or shows no face.
[[nodiscard]] Result<void> read_freecad_document(ModelFile& model, const std::string& archive);

}  // namespace suture::io

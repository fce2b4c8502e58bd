#pragma once

#include "files/model_file.h"

#include <string>
#include <vector>

namespace suture::io {

/// What of a model a format has no place for, one sentence each: of IGES and BREP the assembly tree
/// and its names, of BREP colours and layers too. Nothing for meshes, which hold a shape's facets
/// and nothing else.
[[nodiscard]] std::vector<std::string> lost_in(const ModelFile& model, Format format);

}  // namespace suture::io

#pragma once

#include "files/model_file.h"
#include "suture/base/result.h"

#include <ostream>
#include <string>

namespace suture::io {

/// Writes a model as IGES in its unit: trimmed surfaces if all its faces are loose, else shells and
/// solids (entities 514 and 186), so that what is sewn stays sewn.
[[nodiscard]] Result<void> write_iges(const ModelFile& model, const std::string& name,
                                      std::ostream& stream);

}  // namespace suture::io

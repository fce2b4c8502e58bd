#pragma once

#include "files/model_file.h"
#include "suture/base/result.h"

#include <ostream>
#include <string>

namespace suture::io {

/// Writes a model as STEP, with its schema (AP214 if it has none) and its unit.
[[nodiscard]] Result<void> write_step(const ModelFile& model, const std::string& name,
                                      std::ostream& stream);

}  // namespace suture::io

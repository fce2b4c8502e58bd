#pragma once

#include "files/model_file.h"
#include "suture/base/result.h"

#include <TopoDS_Shape.hxx>

#include <string>

namespace suture::io {

/// A model of one part that comes from no file.
[[nodiscard]] Result<ModelFile> make_model(const TopoDS_Shape& shape, const std::string& name);

}  // namespace suture::io

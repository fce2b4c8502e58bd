#pragma once

#include "suture/base/result.h"

#include <TopoDS_Shape.hxx>

#include <filesystem>

namespace suture::io {

/// Refuses  (Unreadable) a model with a number that none of the work after reading can bear: a
///          coordinate or a tolerance that is no number or larger than 1e13 mm, an edge whose
///          parameters are none or run backwards; names the vertex, edge or face. OCCT loops for
///          ever on such ranges. Likewise an orientation that is none.
[[nodiscard]] Result<void> check_numbers(const TopoDS_Shape& shape,
                                         const std::filesystem::path& file);

}  // namespace suture::io

#pragma once

#include "files/model_file.h"
#include "files/step_scan.h"
#include "suture/base/result.h"

#include <TopoDS_Face.hxx>

#include <ostream>
#include <span>
#include <string>
#include <vector>

namespace suture::io {

/// Writes a model as STEP, with its schema (AP214 if it has none) and its unit.
///
/// Result   the entity numbers that the faces in `traced` have got; 0 for one that OCCT has lost
///          sight of.
[[nodiscard]] Result<std::vector<StepId>> write_step(const ModelFile& model,
                                                     const std::string& name,
                                                     std::span<const TopoDS_Face> traced,
                                                     std::ostream& stream);

}  // namespace suture::io

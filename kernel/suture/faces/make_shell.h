#pragma once

#include "suture/base/result.h"
#include "suture/model/patch.h"

#include <TopoDS_Shell.hxx>

namespace suture {

/// Patches that stand for themselves, with no hole around them, as one shell.
///
/// Input    sheet: every edge is an inner edge, that of its border too.
/// Refuses  a patch that OCCT cannot take.
[[nodiscard]] Result<TopoDS_Shell> make_shell(const FillResult& sheet);

}  // namespace suture

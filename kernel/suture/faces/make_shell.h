#pragma once

#include "suture/base/result.h"
#include "suture/model/patch.h"

#include <TopoDS_Shell.hxx>

#include <vector>

namespace suture {

/// Patches that stand for themselves, with no hole around them, as one shell.
///
/// Input    sheet: every edge is an inner edge, that of its border too.
/// Refuses  a patch that OCCT cannot take.
[[nodiscard]] Result<TopoDS_Shell> make_shell(const FillResult& sheet);

/// A fill with the hole's sides as edges of its own, so that it stands for itself.
///
/// Input  corners[l][i]: where side i of loop l starts.
[[nodiscard]] FillResult without_hole(FillResult fill,
                                      const std::vector<std::vector<Eigen::Vector3d>>& corners);

}  // namespace suture

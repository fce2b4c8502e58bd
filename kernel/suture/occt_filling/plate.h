#pragma once

#include "suture/base/progress.h"
#include "suture/base/result.h"
#include "suture/detect/boundary_loop.h"
#include "suture/model/patch.h"
#include "suture/model/ribbon.h"

#include <TopoDS_Face.hxx>

#include <chrono>
#include <string_view>
#include <vector>

namespace suture {

/// Settings of OCCT's filling: its defaults, or the best single setting we measured.
enum class PlateSetting {
    Default,
    Tuned,  ///< energy degree 4, maximal degree 14, 40 segments, 3D tolerance 1e-6
};

/// OCCT's own filling (BRepOffsetAPI_MakeFilling): the method to beat, kept for comparison.
///
/// Runs in a process of its own: a crash, or no answer within `limit`, is an error.
/// Result   one surface with trimming curves, as a FillResult.
/// Refuses  several loops (OCCT would close the wrong hole), and whatever OCCT refuses.
[[nodiscard]] Result<FillResult> fill_with_plate(const std::vector<BoundaryLoop>& loops,
                                                 const Hole& hole, PlateSetting setting,
                                                 std::chrono::milliseconds limit,
                                                 const Progress& progress);

}  // namespace suture

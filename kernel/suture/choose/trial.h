#pragma once

#include "suture/base/progress.h"
#include "suture/base/result.h"
#include "suture/base/tolerance.h"
#include "suture/check/fill_measures.h"
#include "suture/detect/boundary_loop.h"
#include "suture/model/patch.h"
#include "suture/model/ribbon.h"

#include <vector>

namespace suture {

/// Builds a fill's faces on copies of the hole's edges and neighbours and measures them with the
/// continuity check: the model itself stays as it is. The numbers in the result are of these
/// copies.
///
/// Refuses  a face that OCCT's BRepCheck does not accept.
[[nodiscard]] Result<FillMeasures> try_fill(const std::vector<BoundaryLoop>& loops,
                                            const Hole& hole, const FillResult& fill,
                                            const Tolerance& tolerance, const Progress& progress);

}  // namespace suture

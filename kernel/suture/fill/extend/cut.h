#pragma once

#include "suture/base/result.h"
#include "suture/fill/extend/region.h"
#include "suture/model/patch.h"

#include <vector>

namespace suture::extend {

/// Cuts a region that goes around the surface open, along a straight line of the domain from corner
/// to corner (or pole) that meets no side. A line of constant `around` is taken where there is one.
///
/// Input    snap: by how far the seam may miss its second corner, in model units.
/// Changes  traces: moved by periods, so that they lie between the two places of the seam.
/// Refuses  when no such line exists; a B-spline's is where its own domain begins.
[[nodiscard]] Result<Seam> cut_open(const Chart& chart, const Region& region,
                                    std::vector<Trace>& traces, double snap);

}  // namespace suture::extend

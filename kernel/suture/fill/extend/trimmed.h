#pragma once

#include "suture/base/result.h"
#include "suture/fill/extend/chart.h"
#include "suture/model/patch.h"
#include "suture/model/ribbon.h"

namespace suture::extend {

/// Whether the outside is -(X_u x X_v).
///
/// Refuses  neighbours that do not agree.
[[nodiscard]] Result<bool> reversed_on(const Surface& surface, const Locate& locate,
                                       const Hole& hole);

/// The part of a surface that a hole's loops bound, as one patch: the surface's own kind, its seam
/// moved out of the hole or made an edge of the patch, a B-spline continued where it is too short.
///
/// Input    surface: the whole border lies on it; locate: where, for a B-spline;
///          reversed: the outside is -(X_u x X_v); distance: how far apart points may lie that are
///          one, in model units.
/// Refuses  loops that bound no one face of the surface, seen from that side.
[[nodiscard]] Result<FillResult> trimmed(const Surface& surface, const Locate& locate,
                                         bool reversed, const Hole& hole, double distance);

}  // namespace suture::extend

#pragma once

#include "suture/base/result.h"
#include "suture/fill/concentric/closed_spline.h"
#include "suture/fill/fill.h"
#include "suture/model/patch.h"
#include "suture/model/ribbon.h"

#include <vector>

namespace suture::concentric {

/// A fair surface across the hole, the one whose curvature varies least. The map is laid into its
/// domain, where the loop is unrolled as its neighbours turn: no plane that it may leave or overlap
/// in is needed.
struct Guide {
    SplineSurface surface;
    std::vector<TrimCurve> sides;  ///< where the ribbons run in its domain
    ClosedSpline loop;             ///< the same, side i on [i, i + 1], as the map needs it
    std::vector<std::string> notes;
};

/// Refuses  what `mvs` refuses.
[[nodiscard]] Result<Guide> guide_of(const Hole& hole, const FillOptions& options);

}  // namespace suture::concentric

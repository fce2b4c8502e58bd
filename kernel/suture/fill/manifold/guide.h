#pragma once

#include "suture/base/result.h"
#include "suture/fill/fill.h"
#include "suture/model/patch.h"

#include <vector>

namespace suture::manifold {

/// A surface across the hole which a patch should come near, and where the ribbons run on it.
struct GuideSurface {
    Surface surface;
    std::vector<TrimCurve> trims;  ///< of the ribbons of the hole's one loop, in their order
};

/// The surface whose curvature varies least.
///
/// Refuses  what `mvs` refuses.
[[nodiscard]] Result<GuideSurface> guide_surface(const Hole& hole, const FillOptions& options);

}  // namespace suture::manifold

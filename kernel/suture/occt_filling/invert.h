#pragma once

#include "suture/model/patch.h"
#include "suture/model/ribbon.h"

#include <memory>
#include <vector>

namespace suture {

/// Where the hole's sides run in the domain of a surface that passes near them: the parameters of
/// the surface's points nearest to the ribbons' points.
///
/// Promises each curve is continuous: found by walking along the loop, from the nearest of a grid
///          of points.
[[nodiscard]] std::vector<std::vector<TrimCurve>> invert_boundary(
    const std::shared_ptr<const SplineSurface>& surface, const Hole& hole);

/// Area that a loop of trimming curves encloses in the domain; positive when walked with the
/// inside on the left.
[[nodiscard]] double signed_area(const std::vector<TrimCurve>& loop);

}  // namespace suture

#pragma once

#include "suture/model/patch.h"
#include "suture/model/ribbon.h"

#include <memory>
#include <vector>

namespace suture {

/// Where the sides of a loop run in the domain of a surface that passes near them: the parameters
/// of the surface's points nearest to the ribbons' points.
///
/// Input     guesses: one curve for each ribbon, roughly there.
/// Result    the guesses themselves where the nearest points make no simple closed curve: so it is
///           with a surface that folds.
/// Promises  each curve is continuous.
[[nodiscard]] std::vector<TrimCurve> invert_boundary(
    const std::shared_ptr<const SplineSurface>& surface, const RibbonLoop& loop,
    const std::vector<TrimCurve>& guesses);

/// Area that a loop of trimming curves encloses in the domain; positive when walked with the
/// inside on the left.
[[nodiscard]] double signed_area(const std::vector<TrimCurve>& loop);

}  // namespace suture

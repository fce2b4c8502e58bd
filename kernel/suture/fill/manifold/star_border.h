#pragma once

#include "suture/fill/manifold/border_fit.h"
#include "suture/fill/manifold/star.h"

namespace suture::manifold {

/// The border of a star, as fit_border takes it.
///
/// Input    diameter: of the hole; centres: of the sides, as spacing_for() gives them; weights: of
/// the
///          energy.
[[nodiscard]] BorderModel border_model(const Star& star, double diameter,
                                       std::vector<double> centres);

}  // namespace suture::manifold

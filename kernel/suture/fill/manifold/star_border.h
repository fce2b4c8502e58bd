#pragma once

#include "suture/fill/manifold/border_fit.h"
#include "suture/fill/manifold/star.h"

namespace suture::manifold {

/// The border of a star, as fit_border takes it.
///
/// Input    diameter: of the hole.
[[nodiscard]] BorderModel border_model(const Star& star, double diameter);

}  // namespace suture::manifold

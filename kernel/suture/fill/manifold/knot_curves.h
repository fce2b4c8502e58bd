#pragma once

#include "suture/fill/manifold/arrangement.h"
#include "suture/fill/manifold/star.h"

#include <vector>

namespace suture::manifold {

/// The curves inside of the border zones across which the polynomials of a star's surface change,
/// and the inner ends of the border zones: lines, and parabolas for k = 1.
///
/// Input    k <= 1.
[[nodiscard]] std::vector<PlaneCurve> knot_curves(const Star& star);

/// The degree in (x, y) of the sums over all charts, next to a point of X.
[[nodiscard]] int polynomial_degree(const Star& star, const Eigen::Vector2d& near);

}  // namespace suture::manifold

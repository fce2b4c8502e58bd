#pragma once

#include "suture/fill/manifold/arrangement.h"
#include "suture/fill/manifold/middle.h"
#include "suture/fill/manifold/surface.h"

namespace suture::manifold {

/// The highest order k for which the middle can be written exactly with sense: for k = 2 its cells
/// have degree 15 and edges of degree 4, for k = 3 degree 28, more than B-splines have in CAD.
inline constexpr int kMostExactOrder = 1;

/// The cells into which the knot curves of all sides cut the middle. On each of them the surface is
/// one rational polynomial.
///
/// Input    k <= kMostExactOrder: knot curves are lines and parabolas.
[[nodiscard]] Result<Arrangement> find_cells(const Star& star);

/// The middle exactly: every cell as a rational Bezier patch over a parallelogram around it,
/// trimmed by the knot curves. The degree is 2 for k = 0; for k = 1 it is 6 where a side is bent,
/// else 4.
///
/// Refuses  k > kMostExactOrder; what arrange() refuses; a cell whose denominator is not positive
///          on a parallelogram around it.
[[nodiscard]] Result<Middle> make_cells(const StarSurface& surface);

}  // namespace suture::manifold

#pragma once

#include "suture/fill/fill.h"

#include <span>

namespace suture {

/// Fills a hole by piecewise algebraic surfaces that join each other with G^k, k >= 0, and the
/// neighbours as nearly as polynomials can, and represents these by biquintic B-spline faces.
///
/// Result    one face for each side and, on the finer partition, for the inner cells, with common
///           edges. The notes say degree, cells, rank and dimension, what was proven, and how near
///           the polynomials come to the neighbours.
/// Promises  inside a band around the surface every ray from the centre meets it exactly once and
///           across it: proven by Bernstein coefficients, or seen on sampled rays, as the notes
///           say.
/// Refuses   fewer than three sides, islands, points to pass through; for k >= 3 a neighbour
/// without
///           an equation and a side that is not planar; neighbours whose normals differ by more
///           than 1 deg at a corner; a hole that is seen single from no centre; where no member
///           up to five degrees above the lowest meets the sides and has a single sheet.
/// Source    Chen, Chen, Deng, Feng, Filling holes with piecewise algebraic surfaces, 2000; the
///           choice of the member and its faces is our own: docs/methods/algebraic.md.
[[nodiscard]] Result<FillResult> fill_algebraic(const Hole& hole, const FillOptions& options);

[[nodiscard]] std::span<const MethodOption> algebraic_options();

}  // namespace suture

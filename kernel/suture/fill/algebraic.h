#pragma once

#include "suture/fill/fill.h"

#include <span>

namespace suture {

/// Fills a hole between algebraic surfaces by piecewise algebraic ones that join them with G^k,
/// k >= 0, and represents these by biquintic B-spline faces.
///
/// Result    one face for each side and, on the finer partition, for the inner cells, with common
///           edges. The notes say degree, cells, rank and dimension, and what was proven.
/// Promises  inside a band around the surface every ray from the centre meets it exactly once and
///           across it: proven by Bernstein coefficients, not sampled.
/// Refuses   fewer than three sides, islands, points to pass through; a neighbour that is no plane,
///           quadric or torus; a side that is not planar; neighbours with different normals at a
///           corner; a hole that is seen single from no centre; where no member of the solution
///           space up to three degrees above the lowest has a provably single sheet.
/// Source    Chen, Chen, Deng, Feng, Filling holes with piecewise algebraic surfaces, 2000; the
///           choice of the member and its faces is our own: docs/methods/algebraic.md.
[[nodiscard]] Result<FillResult> fill_algebraic(const Hole& hole, const FillOptions& options);

[[nodiscard]] std::span<const MethodOption> algebraic_options();

}  // namespace suture

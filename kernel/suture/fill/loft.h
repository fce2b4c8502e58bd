#pragma once

#include "suture/fill/fill.h"

namespace suture {

/// The bridge between two opposite sides: across from one to the other it is a cubic, tangent to
/// both neighbours, and its free sides are the curves that bound it there.
///
/// Result   one B-spline patch, cubic across; position and tangency of both neighbours to the
///          accuracy of the fit along them, exact where these are polynomials.
/// Refuses  a hole that has not just four sides, two opposite ones of them curves without a face
///          that are such cubics.
/// Source   Ferguson, Multivariable curve interpolation, 1964: cubic Hermite blending.
[[nodiscard]] Result<FillResult> fill_loft(const Hole& hole, const FillOptions& options);

}  // namespace suture

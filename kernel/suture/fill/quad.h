#pragma once

#include "suture/fill/fill.h"

namespace suture {

/// Coons' patch over a loop of four sides: one untrimmed B-spline face whose borders the sides are,
/// the ruled surface where two opposite ones are straight.
///
/// Result   one patch of bidegree 5, its sides in arc length; fit_error is that of the sides.
/// Promises the surface meets every side that asks for tangency within the angle's tolerance.
/// Refuses  islands and inner points; other than four sides; a corner of less than 5 or more than
///          175 degrees; a side that is no smooth curve; a patch that folds; a side that asks for
///          tangency and does not get it, naming it and the angle.
/// Source   S. Coons, Surfaces for computer-aided design of space forms, MIT, 1967.
[[nodiscard]] Result<FillResult> fill_quad(const Hole& hole, const FillOptions& options);

}  // namespace suture

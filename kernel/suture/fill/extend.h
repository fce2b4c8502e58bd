#pragma once

#include "suture/fill/fill.h"

namespace suture {

/// Continues the one surface on which all neighbours lie: plane, cylinder, cone, sphere, torus or
/// B-spline.
///
/// Result   one patch on that surface, exact. The seam of a closed surface is moved out of the
///          hole; what goes all the way around gets a seam of its own. A B-spline
///          goes on beyond its domain with its outermost polynomials.
/// Refuses  neighbours on different surfaces or on one without a closed form, naming the two faces;
///          loops that bound no one face of the surface.
[[nodiscard]] Result<FillResult> fill_extend(const Hole& hole, const FillOptions& options);

}  // namespace suture

#pragma once

#include "suture/fill/fill.h"

namespace suture {

/// Continues the one surface on which all neighbours lie: plane, cylinder, cone, sphere, torus or
/// B-spline.
///
/// Result   one patch on that surface, exact. The seam of a closed surface is moved out of the
///          hole; a B-spline goes on beyond its domain with its outermost polynomials.
/// Refuses  neighbours on different surfaces or on one without a closed form, naming the two faces;
///          a hole that goes all the way around the surface's axis or over its pole.
[[nodiscard]] Result<FillResult> fill_extend(const Hole& hole, const FillOptions& options);

}  // namespace suture

#pragma once

#include "suture/model/ribbon.h"
#include "suture/model/surface.h"

namespace suture::extend {

/// A frame for a sphere in which the hole is as simple as possible and its sides keep away from the
/// poles: best a disc, else a band between two loops, else a cap with one of the poles in it.
///
/// Result   the sphere's own frame wherever no other is better.
[[nodiscard]] Frame sphere_frame(const Sphere& sphere, const Hole& hole, bool reversed);

}  // namespace suture::extend

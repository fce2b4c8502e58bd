#pragma once

#include "suture/model/ribbon.h"
#include "suture/model/surface.h"

namespace suture::extend {

/// A frame for a sphere in which the hole is as simple as possible: best a disc between meridians
/// and circles of latitude, a pole in one of its corners or not. Else its sides keep away from the
/// poles: a disc, then a band between two loops, then a cap with one of the poles in it.
///
/// Result   the sphere's own frame wherever no other is better.
[[nodiscard]] Frame sphere_frame(const Sphere& sphere, const Hole& hole, bool reversed);

}  // namespace suture::extend

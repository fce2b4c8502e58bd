#pragma once

#include "suture/fill/mvs/net.h"

#include <Eigen/Core>

#include <vector>

namespace suture::mvs {

/// Lays the poles that have no part in the face where they bend the rest of the surface least: the
/// flat second-order energy over the box, so that it goes on about straight. The objective
/// continues the surface with all its curvature, and in the corners of the box it may then cross
/// itself. Programs that trim again, or check a face on its whole rectangle, see that.
///
/// Input    the loops of the domain's boundary as closed polygons (2 x count).
/// Changes  the poles of functions that vanish on the whole domain; no point of the face moves.
void settle_outside(const std::vector<Eigen::Matrix2Xd>& polygons, Net& net);

}  // namespace suture::mvs

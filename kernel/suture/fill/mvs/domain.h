#pragma once

#include "suture/fill/mvs/layout.h"
#include "suture/fill/mvs/net.h"
#include "suture/fill/mvs/samples.h"

#include <vector>

namespace suture::mvs {

/// Points of the domain's boundary as closed polygons in the solver's unit, for tests of inside.
[[nodiscard]] std::vector<Eigen::Matrix2Xd> polygons_of(const std::vector<BoundarySample>& samples);

/// Where a point's foot on the surface lies: Gauss and Newton's method, within the box.
///
/// Input    point in the solver's unit; near: parameters to start from.
[[nodiscard]] Eigen::Vector2d footpoint(const Net& net, const Eigen::Vector3d& point,
                                        const Eigen::Vector2d& near);

/// Lays islands and inner points on a surface found without them, or with them somewhere else: each
/// of their points at its foot.
void lay_on_surface(const Net& net, const Scale& scale, const Hole& hole, Domain& domain);

}  // namespace suture::mvs

#pragma once

#include "suture/fill/mvs/knot_lines.h"
#include "suture/fill/mvs/net.h"

#include <Eigen/Core>

#include <vector>

namespace suture::mvs {

/// The largest jump of normal curvature across knot lines, in the solver's unit, at places inside
/// closed polygons that are farther than a distance from these: where eyes would see it.
[[nodiscard]] double largest_jump(const Net& net, const std::vector<KnotLine>& lines,
                                  const std::vector<Eigen::Matrix2Xd>& polygons,
                                  double from_boundary);

}  // namespace suture::mvs

#pragma once

#include "suture/fill/mvs/net.h"
#include "suture/fill/mvs/samples.h"

#include <vector>

namespace suture::mvs {

/// How far a surface misses one boundary sample, in the solver's unit and radians.
struct Miss {
    double gap = 0.0;
    double angle = 0.0;      ///< between the normals, oriented; 0 where no tangency is wanted
    double curvature = 0.0;  ///< |k1 - k2| across the boundary; 0 where it is not wanted
};
[[nodiscard]] Miss miss(const Net& net, const BoundarySample& sample);

/// The largest of each over all samples.
[[nodiscard]] Miss worst_miss(const Net& net, const std::vector<BoundarySample>& samples);

/// The least area element |X_u x X_v| over the domain inside closed polygons, against their mean:
/// negative where the normal turns over between points a third of a span apart.
[[nodiscard]] double regularity(const Net& net, const std::vector<Eigen::Matrix2Xd>& polygons);

}  // namespace suture::mvs

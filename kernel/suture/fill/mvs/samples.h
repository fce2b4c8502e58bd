#pragma once

#include "suture/fill/mvs/layout.h"
#include "suture/model/ribbon.h"

#include <Eigen/Core>

#include <vector>

namespace suture::mvs {

/// Similarity to the unit in which the solver works: the hole about the origin, about 1 across.
struct Scale {
    Eigen::Vector3d centre = Eigen::Vector3d::Zero();
    double length = 1.0;
};

/// What the surface has to do at one boundary point, in the solver's unit.
struct BoundarySample {
    int ribbon = 0;
    double s = 0.0;
    double length = 0.0;     ///< of the boundary for which this sample stands
    Eigen::Vector2d uv;      ///< in the domain
    Eigen::Vector2d across;  ///< unit normal of the domain's boundary, inward
    Eigen::Vector3d point;
    Eigen::Vector3d normal;
    Eigen::Vector3d inward;
    Eigen::Matrix3d curvature;
    Continuity continuity = Continuity::G1;
};

/// Samples at equal arc lengths, about `spacing` apart (in the solver's unit) and at least
/// `least` on a side. `ends`: with the corners; else in the middle of equal pieces, which lie
/// between the former.
[[nodiscard]] std::vector<BoundarySample> sample_boundary(const RibbonLoop& loop,
                                                          const Layout& layout, const Scale& scale,
                                                          double spacing, int least, bool ends);

}  // namespace suture::mvs

#pragma once

#include "suture/base/result.h"
#include "suture/fill/algebraic/neighbour.h"
#include "suture/fill/fill.h"

#include <Eigen/Core>

#include <vector>

namespace suture::algebraic {

/// A point of the surface that the algebraic one should resemble, in unit coordinates.
struct GuidePoint {
    Eigen::Vector3d point;
    Eigen::Vector3d normal;  ///< outward, of length 1
};

/// Points all over a hole and along its boundary, on the surface whose curvature varies least.
///
/// Refuses  what `mvs` refuses.
[[nodiscard]] Result<std::vector<GuidePoint>> guide_by_mvs(const Hole& hole, const Unit& unit,
                                                           const FillOptions& options);

}  // namespace suture::algebraic

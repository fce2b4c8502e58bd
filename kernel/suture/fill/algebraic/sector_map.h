#pragma once

#include "suture/fill/algebraic/sheet.h"
#include "suture/fill/algebraic/solution.h"

#include <Eigen/Core>

namespace suture::algebraic {

/// A sector as the image of the unit square, in barycentric coordinates of its rays: v = 0 runs
/// from ray 0 to ray 1, along the side of the hole if there is one, at the side's own s. Towards v
/// = 1 lines shrink to a short one through ray 2, so that the map is regular all over the sector,
/// which is the square trimmed by the curves to that ray.
///
///         +----- 2 -----+   v = 1, `width` of the first line
///          \    / \    /
///           \ /     \ /
///            0 ----- 1      v = 0
class SectorMap {
  public:
    SectorMap(const Problem& problem, const Solution& solution, int sector, double width);

    [[nodiscard]] Eigen::Vector3d operator()(double u, double v) const;

    /// Where a point between the rays comes from.
    [[nodiscard]] Eigen::Vector2d inverse(const Eigen::Vector3d& b) const;

  private:
    UnitCurve curve_;  ///< none: straight
    Eigen::Vector3d centre_;
    Eigen::Matrix3d directions_;
    double width_;

    [[nodiscard]] Eigen::Vector3d base(double u) const;
};

}  // namespace suture::algebraic

#pragma once

#include "suture/fill/manifold/surface.h"
#include "suture/spline/surface.h"

#include <optional>

namespace suture::manifold {

/// Where a surface turns over: between two samples next to each other its normal turns by more than
/// 120 degrees, so that its Jacobian changes sign against either of them.
struct Fold {
    Eigen::Vector3d at = Eigen::Vector3d::Zero();
    double angle = 0.0;  ///< between the two normals
    int side = 0;        ///< of a star: the nearest
};

/// The sharpest fold within the borders of a star's surface, on samples all over each side.
[[nodiscard]] std::optional<Fold> find_fold(const StarSurface& surface);

/// The same of a ring's spline, whose first row of poles is its apex.
[[nodiscard]] std::optional<Fold> find_fold(const SplineSurface& ring);

}  // namespace suture::manifold

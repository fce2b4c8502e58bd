#pragma once

#include "suture/spline/surface.h"

#include <Eigen/Core>

#include <functional>

namespace suture::algebraic {

/// The B-spline surface over [0,1] x [0,1] with uniform clamped knots that takes a map's values at
/// its Greville sites. Values that are not finite give poles that are not.
///
/// Source  de Boor, A practical guide to splines, ch. XIII and XVII.
[[nodiscard]] SplineSurface interpolate(
    const std::function<Eigen::Vector3d(double u, double v)>& map, int degree, int spans);

}  // namespace suture::algebraic

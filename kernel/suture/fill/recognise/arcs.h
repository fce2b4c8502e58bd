#pragma once

#include "suture/base/result.h"
#include "suture/fill/recognise/spine.h"
#include "suture/spline/surface.h"

#include <vector>

namespace suture::recognise {

/// A surface that approximates a rolling ball's envelope, and how well.
struct ArcSurface {
    SplineSurface surface;  ///< u along the path, v across it
    double error = 0.0;     ///< largest distance from the ball's own surface, model units
};

/// Rational quadratic arcs of circles about the path's centres, from a little beyond one contact to
/// a little beyond the other, joined along the path by quintic interpolation of their homogeneous
/// control points: with as many positions as the accuracy needs.
///
/// Refuses  a path on which the ball's own positions cannot be found again.
[[nodiscard]] Result<ArcSurface> fit_arcs(const RollingBall& ball,
                                          const std::vector<BallPosition>& path, double accuracy);

}  // namespace suture::recognise

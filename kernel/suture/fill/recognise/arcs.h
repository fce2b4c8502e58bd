#pragma once

#include "suture/base/result.h"
#include "suture/fill/recognise/spine.h"
#include "suture/spline/surface.h"

#include <vector>

namespace suture::recognise {

/// A surface that approximates a rolling ball's envelope, and how well.
struct ArcSurface {
    SplineSurface surface;  ///< u across the path, v along it
    double error = 0.0;     ///< largest distance from the ball's own surface, model units
};

/// A part of a ball's path on which it touches the same two surfaces.
struct PathPart {
    RollingBall ball;
    std::vector<BallPosition> positions;
};

/// Rational quadratic arcs of circles about the path's centres, from a little beyond one contact to
/// a little beyond the other, joined along the path by quintic interpolation of their homogeneous
/// control points: with as many positions as the accuracy needs.
///
/// Input    parts: at least one, each beginning where the one before it ends. The path's curvature
///          may jump there; the surface keeps its tangent planes, but not its derivatives.
/// Refuses  a path on which the ball's own positions cannot be found again.
[[nodiscard]] Result<ArcSurface> fit_arcs(const std::vector<PathPart>& parts, double accuracy);

}  // namespace suture::recognise

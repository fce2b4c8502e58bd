#pragma once

#include "suture/fill/manifold/middle.h"
#include "suture/fill/manifold/quad_map.h"
#include "suture/fill/manifold/surface.h"
#include "suture/spline/surface.h"

#include <vector>

namespace suture::manifold {

/// The middle of a star's surface as n biquintic quads, each laid into X by QuadMap.
struct Centre {
    std::vector<SplineSurface> quads;  ///< quad m lies between the spokes m and m + 1
    double error = 0.0;  ///< largest distance from the surface at the same point of X, as sampled
    int spans = 0;       ///< of a quad, in each direction
};

/// Fits the middle of the surface.
///
/// Quads meet the border zone exactly in position and cross derivative, and each other in position
/// and tangent plane: with C the spoke's own curve, the cross derivatives on its two sides are
/// c + b C' and -c + b C', with one spline c and one polynomial b for both.
///
/// Input    tolerance: spans get shorter, each as its own error asks for, until the error is below
///          it, or there are `most_spans` or a few more.
[[nodiscard]] Centre fit_centre(const StarSurface& surface, double tolerance, int most_spans);

/// The quads as patches:
///
///                K_m ----------- A_m ----------- K_(m-1)
///                  |   quad m     |   quad m-1   |
///                  +------------- O -------------+
[[nodiscard]] Middle quads_of(const StarSurface& surface, const Centre& centre);

}  // namespace suture::manifold

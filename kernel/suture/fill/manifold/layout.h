#pragma once

#include "suture/fill/manifold/middle.h"
#include "suture/fill/manifold/surface.h"
#include "suture/model/patch.h"

#include <functional>
#include <vector>

namespace suture::manifold {

/// An edge of the hole that lies along the border of side m.
struct SideEdge {
    int ribbon = 0;
    /// y on the side, rising, as a function of the ribbon's s.
    std::function<double(double s)> y;
};

/// The patches of a star: n strips, each the exact B-spline of a border zone (Theorem 1) from the
/// border to where the zones begin, mitred along the diagonals of its two corner blocks; and those
/// of the middle.
///
///         corner m -------- border of side m -------- corner m-1
///               \                                    /
///                \ mitre        strip m             /      Both strips at a mitre are the same
///                 \                                /       B-spline there.
///                K_m ---------------------------- K_(m-1)
///                  |            middle             |
///
/// Input    edges[m]: the hole's edges along side m, in order; empty: the patch stands for itself
///          and gets edges and vertices of its own.
///          A patch of the fewest layers has no border zone, and no strips: only for itself.
[[nodiscard]] FillResult lay_out(const StarSurface& surface, Middle middle,
                                 const std::vector<std::vector<SideEdge>>& edges);

/// The B-spline of side m between the beginning of the border zone and the border: u is x - mu(y),
/// v is y.
[[nodiscard]] SplineSurface border_spline(const StarSurface& surface, int m);

/// y at the corner that side m shares with side m + 1, and that it shares with side m - 1.
[[nodiscard]] double upper_end(const Star& star, int m);
[[nodiscard]] double lower_end(const Star& star, int m);

}  // namespace suture::manifold

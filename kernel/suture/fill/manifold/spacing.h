#pragma once

#include "suture/fill/manifold/star.h"

#include <vector>

namespace suture::manifold {

/// A star whose border has its knots where a hole needs them.
struct Spacing {
    StarSize size;
    /// Of each side the place, from -1 to 1 of its length, that lies in the middle of its range of
    /// y: so that no joint falls next to the middle and no layer becomes too thin there.
    std::vector<double> centres;
};

/// Knots for sides on which ribbons join: where they do, knots crowd from both sides, each half as
/// far away as the last one. A curvature that jumps or a small kink is then followed as well as the
/// rest of the side.
///
///      |       |       |   |  ||||  |   |       |       |
///                           joint
///
/// Knots along a side are those of the rays beside it (L_m) and its own in the middle (C_m), so
/// that other sides get layers from them; all rays get as many.
///
/// Input    layers: to the border, where nothing joins; joints[m]: of side m, shares of its length;
///          levels: how often the distance is halved.
[[nodiscard]] Spacing spacing_for(int k, int layers, double aperture,
                                  const std::vector<std::vector<double>>& joints, int levels);

}  // namespace suture::manifold

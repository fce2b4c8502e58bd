#pragma once

#include "suture/fill/recognise/agreement.h"

#include <string>
#include <utility>
#include <vector>

namespace suture::recognise {

/// A surface that was known again: the one that the lost face had.
struct Recognised {
    std::string kind;  ///< "torus", "rolling ball", ...
    /// "major radius" and others, in model units and degrees
    std::vector<std::pair<std::string, double>> parameters;
};

/// What a closed form is, in model units.
[[nodiscard]] Recognised describe(const Surface& form);

/// What a rolling ball's envelope is.
[[nodiscard]] Recognised describe_ball(double radius);

/// "torus R = 12, r = 3, tangent to faces 4, 7, 9; axis parallel to face 4's".
[[nodiscard]] std::string sentence(const Recognised& recognised, const Agreement& agreement,
                                   const std::vector<std::string>& facts);

}  // namespace suture::recognise

#pragma once

#include "suture/fill/recognise/agreement.h"
#include "suture/model/recognised.h"

#include <string>
#include <vector>

namespace suture::recognise {

/// What a closed form is, in model units, and how well the border fits it.
[[nodiscard]] Recognised describe(const Surface& form, const Agreement& agreement,
                                  const Border& border);

/// What a rolling ball's envelope is.
///
/// Input    sides: how many it touches.
[[nodiscard]] Recognised describe_ball(double radius, std::size_t sides, const Agreement& agreement,
                                       const Border& border);

/// "torus R = 12, r = 3, tangent to faces 4, 7, 9; axis parallel to face 4's".
[[nodiscard]] std::string sentence(const Recognised& recognised, const Agreement& agreement,
                                   const std::vector<std::string>& facts);

}  // namespace suture::recognise

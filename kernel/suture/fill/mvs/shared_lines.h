#pragma once

#include "suture/fill/mvs/layout.h"
#include "suture/fill/mvs/samples.h"

#include <array>
#include <cstddef>
#include <vector>

namespace suture::mvs {

/// Corners nearer to one another than this, in the solver's unit, are on one line anyway.
inline constexpr double kSameLine = 1e-5;

/// Moves corners of a layout a little so that some of them come to lie on one line of the net: a
/// line takes four knots, and one serves as many corners as lie on it. Sides keep their directions
/// at the ends; they bend and stretch by a small part of their length.
///
/// Input    through[0], through[1]: the corners, as indices of the sides that begin there, that
///          want a line u = const, and v = const.
/// Result   the corners of each line, and the layout with them in their places.
[[nodiscard]] std::array<std::vector<std::vector<std::size_t>>, 2> share_lines(
    const std::array<std::vector<std::size_t>, 2>& through, const Scale& scale, Layout& layout);

}  // namespace suture::mvs

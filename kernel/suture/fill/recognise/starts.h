#pragma once

#include "suture/fill/recognise/border.h"

#include <array>
#include <vector>

namespace suture::recognise {

/// Closed forms by kind, in the order plane, sphere, cylinder, cone, torus.
constexpr int kKinds = 5;
using Starts = std::array<std::vector<Surface>, kKinds>;

/// Where to look for the closed form on which a border lies: by linear least squares from the
/// normals along all sides and along subsets of them (a side may be sharp), about the neighbours'
/// axes and those of circular sides, along the neighbours' directions.
///
/// Input    the border; all in its coordinates.
/// Source   Pottmann & Randrup, Rotational and helical surface approximation for reverse
///          engineering, Computing 60 (1998): the axis of a surface of revolution meets all of its
///          normals; Kasa, IEEE Trans. Instrum. Meas. 25 (1976): the circle.
[[nodiscard]] Starts starts_for(const Border& border);

/// The same about and along the line between the middles of two loops, by points alone; nothing
/// where there are not two.
[[nodiscard]] Starts rim_starts(const Border& border);

/// The neighbours' own directions: axes, normals of planes.
[[nodiscard]] std::vector<Frame> neighbour_axes(const Border& border);

}  // namespace suture::recognise

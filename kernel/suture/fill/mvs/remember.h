#pragma once

#include "suture/model/ribbon.h"

namespace suture::mvs {

/// The same hole, but its ribbons keep the points that they were asked for: the levels of a fill
/// sample the boundary at many of the same parameters, and on a model one point costs as much as a
/// thousand operations. For one thread.
[[nodiscard]] Hole remember(const Hole& hole);

}  // namespace suture::mvs

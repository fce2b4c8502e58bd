#pragma once

#include "suture/fill/fill.h"

namespace suture {

/// Closes a planar loop, with or without islands, by a plane.
///
/// Result   one planar patch, exact; position only: where the neighbours happen to be tangent to
///          the plane, the result is smooth as well.
/// Refuses  a loop that leaves its plane by more than the length tolerance, naming the side.
[[nodiscard]] Result<FillResult> fill_plane(const Hole& hole, const FillOptions& options);

}  // namespace suture

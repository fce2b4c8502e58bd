#pragma once

#include "suture/base/result.h"
#include "suture/fill/algebraic/solution.h"

namespace suture::algebraic {

/// Refuses  a corner that two sides and their interface meet with G^2 or more while the neighbours'
///          second fundamental forms differ there: every solution of the system, of any degree, has
///          a vanishing gradient in such a corner.
[[nodiscard]] Result<void> expect_agreeing_corners(const Problem& problem);

}  // namespace suture::algebraic

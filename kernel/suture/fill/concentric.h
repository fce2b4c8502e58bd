#pragma once

#include "suture/fill/fill.h"

namespace suture {

/// The concentric fill: a disc-like surface whose one parameter runs around the boundary, the other
/// from the boundary inwards to the sheet of its medial axis, where all spokes end at once.
///
/// Result    one face for each side of the hole, or one for all (option `faces`), sewn along the
///           seams and along the sheet. The edges' own curves and parameters are the surfaces'
///           borders, exactly where they are polynomial.
/// Promises  the map does not fold: the sign of its Jacobian is proved.
/// Refuses   islands; a loop that crosses or nearly touches itself.
/// Source    Martin & Cohen, Surface completion of an irregular boundary curve using a concentric
///           mapping, 2003; docs/methods/concentric.md tells where we depart from it.
[[nodiscard]] Result<FillResult> fill_concentric(const Hole& hole, const FillOptions& options);

/// What `--option` may set for it.
[[nodiscard]] std::span<const MethodOption> concentric_options();

}  // namespace suture

#pragma once

#include "suture/fill/fill.h"

namespace suture {

/// Gives back the surface that the lost face had, where the hole's border and its neighbours tell
/// it: plane, sphere, cylinder, cone, torus, the envelope of a rolling ball.
///
/// Result   one patch of that kind, with plain numbers where they fit as well, exact in itself but
///          for the ball's, whose error is given; a note says what was recognised.
///          options.recognised is told the figures.
/// Refuses  a border that lies on no such surface, or tells too little to be believed; a flat one
///          of which only position is asked for, but for the surface of a face and its copies.
/// Source   docs/methods/recognise.md
[[nodiscard]] Result<FillResult> fill_recognise(const Hole& hole, const FillOptions& options);

}  // namespace suture

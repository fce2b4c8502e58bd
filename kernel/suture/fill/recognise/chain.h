#pragma once

#include "suture/fill/recognise/arcs.h"
#include "suture/fill/recognise/ball.h"

#include <vector>

namespace suture::recognise {

/// One ball that goes from pair of sides to pair of sides: where one of the two sides ends, or
/// both, it touches the next.
///
/// Input    guesses: of all pairs, the most certain first; the chain goes through that one.
/// Result   in the order in which the first sides follow each other around the hole, their sides
///          in the same order too; one link: no chain.
[[nodiscard]] std::vector<BallGuess> find_chain(const std::vector<BallGuess>& guesses,
                                                const Border& border);

/// The surface that a ball envelops along one link or more, over all of the border.
///
/// Refuses  sides that no such ball touches; a path that ends before the border or a joint;
///          links between which the ball would leap.
[[nodiscard]] Result<ArcSurface> chain_surface(std::vector<BallGuess> chain, double radius,
                                               const Border& border, double accuracy);

}  // namespace suture::recognise

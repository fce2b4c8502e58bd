#pragma once

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

/// The surface that such a ball envelops, over all of the border.
///
/// Refuses  besides what one ball is refused for: two pairs between which it leaps.
[[nodiscard]] Result<ArcSurface> chain_surface(std::vector<BallGuess> chain, double radius,
                                               const Border& border, double accuracy);

}  // namespace suture::recognise

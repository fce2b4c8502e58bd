#pragma once

#include "suture/fill/recognise/border.h"

#include <vector>

namespace suture::recognise {

/// A ball of constant radius that touches two sides of a hole all along.
struct BallGuess {
    std::size_t sides[2] = {0, 0};
    double radius = 0.0;  ///< signed, model units; positive: its centre lies inside of the material
    double spread = 0.0;  ///< median absolute deviation of the radius, as a share of it
    double at[2] = {0.5, 0.5};  ///< where on the two sides it stands at once, in s
};

/// Pairs of sides, with supports, between which such a ball rolls; the most certain first.
///
/// For a point p1, n1 of one side the point of the other is sought at which |(p1 - p2) - r (n1 -
/// n2)| is least, with r = (p1 - p2).(n1 - n2) / |n1 - n2|^2.
[[nodiscard]] std::vector<BallGuess> guess_balls(const Border& border);

/// A radius to try, and how probable it is that another one is as plain.
struct BallRadius {
    double value = 0.0;  ///< signed
    double chance = 1.0;
};

/// The radii to try for a guess: a neighbour's, round in millimetres or inches, the one that was
/// measured.
[[nodiscard]] std::vector<BallRadius> radii_for(const BallGuess& guess, const Border& border);

}  // namespace suture::recognise

#pragma once

#include "suture/fill/algebraic/rational.h"
#include "suture/fill/algebraic/system.h"

#include <vector>

namespace suture::algebraic {

/// The solutions of a System in exact arithmetic.
struct ExactSpace {
    int rank = 0;
    int dimension = 0;  ///< of the solutions x
    /// A basis of the polynomials g that they stand for: fewer than `dimension` where some x leave
    /// g unchanged. In reduced echelon form: basis[n] is 1 at row pivots[n] of the image, where all
    /// others are 0.
    std::vector<std::vector<Rational>> basis;
    std::vector<int> pivots;
};

[[nodiscard]] ExactSpace solve_exactly(const System<Rational>& system);

/// The rank alone.
[[nodiscard]] int exact_rank(const System<Rational>& system);

}  // namespace suture::algebraic

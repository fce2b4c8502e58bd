#pragma once

#include "suture/base/progress.h"
#include "suture/base/result.h"
#include "suture/fill/algebraic/exact.h"
#include "suture/fill/algebraic/neighbour.h"
#include "suture/fill/algebraic/solution.h"

#include <optional>
#include <vector>

namespace suture::algebraic {

/// A hole given by exact polynomials, as the paper's examples are: side i runs from corner i to
/// corner i + 1 on f_i = 0 and F_i = 0, seen counterclockwise from outside; all planes meet in the
/// centre.
struct ExactProblem {
    std::vector<Side<Rational>> sides;
    std::vector<Point<Rational>> corners;
    Point<Rational> centre = {0, 0, 0};
    std::optional<Point<Rational>> outer;  ///< on the axis; none: the mean of the corners
    int k = 1;
    Search search;
    std::optional<double>
        sphere;  ///< radius of a guide about the centre; none: the fairest surface
};

/// A member of the solution space with rational coefficients: every identity holds exactly.
struct ExactSolution {
    Unit unit;        ///< of what follows
    Problem problem;  ///< in unit coordinates
    Solution found;   ///< its cells are `cells` rounded, in unit coordinates
    int rank = 0, dimension = 0, polynomials = 0;  ///< in exact arithmetic
    std::vector<Polynomial<Rational>> cells;       ///< in the problem's own coordinates
};

/// Refuses  (Usage) data that fit together badly: a plane that misses the centre, a corner off its
///          surfaces, a curve that does not lead to the next corner; (Refused) a hole that has no
///          solution, as find_solution does.
[[nodiscard]] Result<ExactSolution> solve(const ExactProblem& problem, const Progress& progress);

}  // namespace suture::algebraic

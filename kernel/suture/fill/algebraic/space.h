#pragma once

#include "suture/fill/algebraic/system.h"

#include <Eigen/Core>

namespace suture::algebraic {

/// The solutions of a System in doubles.
struct Space {
    int degree = 0;
    int rank = 0;
    int dimension = 0;  ///< of the solutions x
    /// Orthonormal columns: the polynomials g that they stand for, cell after cell.
    Eigen::MatrixXd basis;
    /// How far each column misses what is asked for; empty where none does. See JetSpace.
    Eigen::VectorXd misses;
};

/// Input  tolerance: a column that is a combination of others to within this share of its length
///        adds nothing to the rank.
[[nodiscard]] Space solve(const System<double>& system, double tolerance);

}  // namespace suture::algebraic

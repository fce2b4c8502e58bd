#pragma once

#include "suture/fill/manifold/star.h"

#include <Eigen/SparseCore>

namespace suture::manifold {

/// Of third, second and first differences. The second ones settle what the third ones leave open.
struct NetWeights {
    double variation = 1.0;
    double plate = 1e-3;
    double membrane = 0.0;
};

/// The fairness of a control net as a quadratic form Q: p^T Q p for one coordinate p of the control
/// points. The sum over the rows and columns of all sides of the squares of third divided
/// differences at the control points' places (Greville), times the area between these,
///     |d_iii|^2 + 3 |d_iij|^2 + 3 |d_ijj|^2 + |d_jjj|^2,
/// the discrete form of the least variation of curvature; of second and of first ones in the same
/// way.
[[nodiscard]] Eigen::SparseMatrix<double> net_energy(const Star& star, const NetWeights& weights);

}  // namespace suture::manifold

#pragma once

#include "suture/fill/manifold/star.h"

#include <Eigen/SparseCore>

namespace suture::manifold {

/// The fairness of a control net as a quadratic form Q: p^T Q p for one coordinate p of the control
/// points. The sum over the rows and columns of all sides of the squares of third divided
/// differences at the control points' places (Greville), times the area between these,
///     |d_iii|^2 + 3 |d_iij|^2 + 3 |d_ijj|^2 + |d_jjj|^2,
/// the discrete form of the least variation of curvature, plus `flat` times the same of second
/// differences, which alone settles what the third ones leave open.
[[nodiscard]] Eigen::SparseMatrix<double> net_energy(const Star& star, double flat);

}  // namespace suture::manifold

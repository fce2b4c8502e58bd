#include "suture/fill/algebraic/space.h"

#include <Eigen/QR>

#include <cmath>

namespace suture::algebraic {
namespace {

using Eigen::MatrixXd;

Eigen::Map<const MatrixXd> as_matrix(const std::vector<double>& values, int rows, int columns) {
    return {values.data(), rows, columns};
}

}  // namespace

Space solve(const System<double>& system, double tolerance) {
    MatrixXd A = as_matrix(system.matrix, system.rows, system.columns);
    MatrixXd image = as_matrix(system.image, system.image_rows, system.columns);
    // Unknowns in units of what they do, so that the tolerance means the same for all.
    for (int c = 0; c < system.columns; ++c) {
        const double size = A.col(c).norm();
        A.col(c) /= size;
        image.col(c) /= size;
    }
    Space space;
    space.degree = system.degree;
    Eigen::ColPivHouseholderQR<MatrixXd> transposed(A.transpose());
    transposed.setThreshold(tolerance);
    space.rank = static_cast<int>(transposed.rank());
    space.dimension = system.columns - space.rank;
    space.basis = MatrixXd::Zero(system.image_rows, 0);
    if (space.dimension == 0) {
        return space;
    }
    // The null space: what is orthogonal to all rows.
    MatrixXd null = MatrixXd::Zero(system.columns, space.dimension);
    null.bottomRows(space.dimension).setIdentity();
    null.applyOnTheLeft(transposed.householderQ());
    Eigen::ColPivHouseholderQR<MatrixXd> of_image(image * null);
    of_image.setThreshold(std::sqrt(tolerance));
    const auto kept = of_image.rank();
    space.basis = MatrixXd::Identity(system.image_rows, kept);
    space.basis.applyOnTheLeft(of_image.householderQ());
    return space;
}

}  // namespace suture::algebraic

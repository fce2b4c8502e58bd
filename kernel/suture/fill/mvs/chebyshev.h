#pragma once

#include <Eigen/Core>

namespace suture::mvs {

/// The count points (1 - cos(pi k / (count - 1))) / 2 of [0,1], both ends included.
[[nodiscard]] Eigen::VectorXd chebyshev_points(int count);

/// The polynomial through values given at chebyshev_points, as a sum of c_k T_k(2 s - 1).
///
/// Input    dim x count values, one column a point.
/// Result   dim x count coefficients.
/// Source   Trefethen, Approximation theory and approximation practice, ch. 3 and 19.
[[nodiscard]] Eigen::MatrixXd chebyshev_coefficients(const Eigen::MatrixXd& values);

/// Values of a sum of c_k T_k at chebyshev_points(count): the inverse of the above.
[[nodiscard]] Eigen::MatrixXd chebyshev_values(const Eigen::MatrixXd& coefficients, int count);

/// The antiderivative that is zero at s = 0; one coefficient more.
[[nodiscard]] Eigen::MatrixXd chebyshev_integral(const Eigen::MatrixXd& coefficients);

/// The matrix W for which values * W are the values of the antiderivative that is zero at s = 0,
/// all values at chebyshev_points(count).
[[nodiscard]] Eigen::MatrixXd chebyshev_integration(int count);

/// The derivative with respect to s; one coefficient less, but at least one.
[[nodiscard]] Eigen::MatrixXd chebyshev_derivative(const Eigen::MatrixXd& coefficients);

/// Clenshaw's sum at s in [0,1]. Rows: as many as the coefficients have, known to the compiler
/// where a curve is walked point by point.
template <int Rows>
[[nodiscard]] Eigen::Matrix<double, Rows, 1> evaluate_chebyshev(
    const Eigen::Matrix<double, Rows, Eigen::Dynamic>& coefficients, double s) {
    using Vector = Eigen::Matrix<double, Rows, 1>;
    const double x2 = 2.0 * (2.0 * s - 1.0);
    Vector b1 = Vector::Zero(coefficients.rows());
    Vector b2 = b1;
    for (Eigen::Index k = coefficients.cols() - 1; k >= 1; --k) {
        b2 = x2 * b1 - b2 + coefficients.col(k);
        b1.swap(b2);
    }
    return 0.5 * x2 * b1 - b2 + coefficients.col(0);
}

}  // namespace suture::mvs

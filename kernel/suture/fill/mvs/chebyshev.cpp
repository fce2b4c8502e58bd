#include "suture/fill/mvs/chebyshev.h"

#include "suture/base/contract.h"
#include "suture/base/tolerance.h"

#include <cmath>

namespace suture::mvs {
namespace {

// cos(pi m / n) for one period of m.
Eigen::VectorXd cosine_table(int n) {
    Eigen::VectorXd table(2 * n);
    for (int m = 0; m < 2 * n; ++m) {
        table[m] = std::cos(kPi * m / n);
    }
    return table;
}

}  // namespace

Eigen::VectorXd chebyshev_points(int count) {
    SUTURE_EXPECTS(count >= 2);
    Eigen::VectorXd points(count);
    for (int k = 0; k < count; ++k) {
        // sin^2 keeps both ends exact and small s accurate.
        const double half = std::sin(0.5 * kPi * k / (count - 1));
        points[k] = half * half;
    }
    points[count - 1] = 1.0;
    return points;
}

Eigen::MatrixXd chebyshev_coefficients(const Eigen::MatrixXd& values) {
    const auto count = static_cast<int>(values.cols());
    SUTURE_EXPECTS(count >= 2);
    const int n = count - 1;
    const Eigen::VectorXd cosines = cosine_table(n);
    Eigen::MatrixXd transform(count, count);  // value j to coefficient k
    for (int k = 0; k <= n; ++k) {
        for (int j = 0; j <= n; ++j) {
            // Point j sits at x = -cos(pi j / n), and T_k(-x) = (-1)^k T_k(x).
            const double sign = k % 2 == 0 ? 1.0 : -1.0;
            const double ends = (j == 0 || j == n ? 0.5 : 1.0) * (k == 0 || k == n ? 0.5 : 1.0);
            transform(j, k) = sign * ends * 2.0 / n * cosines[(j * k) % (2 * n)];
        }
    }
    return values * transform;
}

Eigen::MatrixXd chebyshev_values(const Eigen::MatrixXd& coefficients, int count) {
    SUTURE_EXPECTS(count >= 2);
    const int n = count - 1;
    const auto terms = static_cast<int>(coefficients.cols());
    const Eigen::VectorXd cosines = cosine_table(n);
    Eigen::MatrixXd transform(terms, count);
    for (int j = 0; j <= n; ++j) {
        for (int k = 0; k < terms; ++k) {
            transform(k, j) = (k % 2 == 0 ? 1.0 : -1.0) * cosines[(j * k) % (2 * n)];
        }
    }
    return coefficients * transform;
}

Eigen::MatrixXd chebyshev_integral(const Eigen::MatrixXd& coefficients) {
    const Eigen::Index count = coefficients.cols();
    Eigen::MatrixXd result = Eigen::MatrixXd::Zero(coefficients.rows(), count + 1);
    // In x = 2 s - 1 the antiderivative of T_k is T_{k+1} / (2 k + 2) - T_{k-1} / (2 k - 2);
    // ds = dx / 2.
    for (Eigen::Index k = 0; k < count; ++k) {
        const double rise = k == 0 ? 1.0 : 0.5 / static_cast<double>(k + 1);
        result.col(k + 1) += 0.5 * rise * coefficients.col(k);
        if (k >= 2) {
            result.col(k - 1) -= 0.25 / static_cast<double>(k - 1) * coefficients.col(k);
        }
    }
    result.col(0) -= evaluate_chebyshev(result, 0.0);
    return result;
}

Eigen::MatrixXd chebyshev_integration(int count) {
    const Eigen::MatrixXd values = Eigen::MatrixXd::Identity(count, count);
    return chebyshev_values(chebyshev_integral(chebyshev_coefficients(values)), count);
}

Eigen::MatrixXd chebyshev_derivative(const Eigen::MatrixXd& coefficients) {
    const Eigen::Index count = coefficients.cols();
    if (count == 1) {
        return Eigen::MatrixXd::Zero(coefficients.rows(), 1);
    }
    Eigen::MatrixXd result = Eigen::MatrixXd::Zero(coefficients.rows(), count - 1);
    for (Eigen::Index k = count - 1; k >= 1; --k) {
        result.col(k - 1) = 4.0 * static_cast<double>(k) * coefficients.col(k);
        if (k + 1 < count - 1) {
            result.col(k - 1) += result.col(k + 1);
        }
    }
    result.col(0) *= 0.5;
    return result;
}

}  // namespace suture::mvs

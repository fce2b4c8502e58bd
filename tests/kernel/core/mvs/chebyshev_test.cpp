#include "suture/fill/mvs/chebyshev.h"

#include <gtest/gtest.h>

#include <cmath>

namespace suture::mvs {
namespace {

constexpr int kCount = 20;

Eigen::MatrixXd sampled() {
    const Eigen::VectorXd s = chebyshev_points(kCount);
    Eigen::MatrixXd values(2, kCount);
    for (int k = 0; k < kCount; ++k) {
        values.col(k) << std::exp(s[k]), std::sin(3.0 * s[k]);
    }
    return values;
}

TEST(Chebyshev, PointsRunFromZeroToOne) {
    const Eigen::VectorXd s = chebyshev_points(5);
    EXPECT_EQ(s[0], 0.0);
    EXPECT_NEAR(s[2], 0.5, 1e-15);
    EXPECT_EQ(s[4], 1.0);
}

TEST(Chebyshev, InterpolatesSmoothFunctions) {
    const Eigen::MatrixXd c = chebyshev_coefficients(sampled());
    for (const double s : {0.0, 0.123, 0.5, 0.77, 1.0}) {
        const Eigen::VectorXd value = evaluate_chebyshev(c, s);
        EXPECT_NEAR(value[0], std::exp(s), 1e-14);
        EXPECT_NEAR(value[1], std::sin(3.0 * s), 1e-14);
    }
    EXPECT_LT((chebyshev_values(c, kCount) - sampled()).norm(), 1e-13);
}

TEST(Chebyshev, IntegratesFromZero) {
    const Eigen::MatrixXd c = chebyshev_integral(chebyshev_coefficients(sampled()));
    const Eigen::MatrixXd values = sampled() * chebyshev_integration(kCount);
    const Eigen::VectorXd s = chebyshev_points(kCount);
    for (int k = 0; k < kCount; ++k) {
        const Eigen::Vector2d expected(std::exp(s[k]) - 1.0, (1.0 - std::cos(3.0 * s[k])) / 3.0);
        EXPECT_LT((evaluate_chebyshev(c, s[k]) - expected).norm(), 1e-14);
        EXPECT_LT((values.col(k) - expected).norm(), 1e-14);
    }
}

TEST(Chebyshev, Differentiates) {
    const Eigen::MatrixXd c = chebyshev_derivative(chebyshev_coefficients(sampled()));
    for (const double s : {0.0, 0.31, 1.0}) {
        const Eigen::VectorXd value = evaluate_chebyshev(c, s);
        EXPECT_NEAR(value[0], std::exp(s), 1e-11);
        EXPECT_NEAR(value[1], 3.0 * std::cos(3.0 * s), 1e-11);
    }
    EXPECT_EQ(chebyshev_derivative(Eigen::MatrixXd::Ones(1, 1))(0, 0), 0.0);
}

}  // namespace
}  // namespace suture::mvs

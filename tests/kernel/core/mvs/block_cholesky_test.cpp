#include "suture/fill/mvs/block_cholesky.h"

#include <Eigen/Cholesky>

#include <gtest/gtest.h>

#include <cmath>

namespace suture::mvs {
namespace {

constexpr int kBlocks = 7;
constexpr int kSize = 3;
constexpr int kWidth = 2;

// A dense positive definite matrix with the band's pattern, and the same as a band.
Eigen::MatrixXd dense() {
    constexpr int kRows = kBlocks * kSize;
    Eigen::MatrixXd A(kRows, kRows);
    for (int i = 0; i < kRows; ++i) {
        for (int j = 0; j < kRows; ++j) {
            const bool inside = std::abs(i / kSize - j / kSize) <= kWidth;
            A(i, j) = inside ? std::cos(0.7 * (i + j) + 0.1 * i * j) : 0.0;
        }
        A(i, i) += 20.0;
    }
    return A;
}

BlockBand band(const Eigen::MatrixXd& A) {
    BlockBand result(kBlocks, kSize, kWidth);
    for (int j = 0; j < kBlocks; ++j) {
        result.column(j) = A.block(kSize * j, kSize * j, result.column(j).rows(), kSize);
    }
    return result;
}

Eigen::VectorXd right_side() {
    return Eigen::VectorXd::LinSpaced(static_cast<Eigen::Index>(kBlocks) * kSize, -1.0, 2.5);
}

TEST(BlockBand, SolvesAsADenseFactorisationDoes) {
    const Eigen::MatrixXd A = dense();
    BlockBand factor = band(A);
    ASSERT_TRUE(factor.factorise());
    const Eigen::VectorXd expected = A.llt().solve(right_side());
    EXPECT_LT((factor.solve(right_side()) - expected).norm(), 1e-14);
}

TEST(BlockBand, MultipliesAsADenseMatrixDoes) {
    const Eigen::MatrixXd A = dense();
    EXPECT_LT((band(A).times(right_side()) - A * right_side()).norm(), 1e-12);
}

TEST(BlockBand, AddsAMultiple) {
    const Eigen::MatrixXd A = dense();
    BlockBand sum = band(A);
    sum.add(band(A), 0.5);
    EXPECT_LT((sum.times(right_side()) - 1.5 * A * right_side()).norm(), 1e-12);
}

TEST(BlockBand, RefusesAnIndefiniteMatrix) {
    Eigen::MatrixXd A = dense();
    A(10, 10) = -1.0;
    BlockBand factor = band(A);
    EXPECT_FALSE(factor.factorise());
}

}  // namespace
}  // namespace suture::mvs

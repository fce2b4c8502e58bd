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

TEST(BlockBand, AddsAMultipleToEveryComponent) {
    const Eigen::MatrixXd A = dense();
    // One row for each component of A: its blocks are tridiagonal, as wide as there are of them.
    constexpr int kComponents = 3;
    constexpr int kRows = kSize / kComponents;
    Eigen::MatrixXd B = Eigen::MatrixXd::Zero(A.rows() / kComponents, A.cols() / kComponents);
    BlockBand small(kBlocks, kRows, kWidth);
    for (int j = 0; j < kBlocks; ++j) {
        for (int i = j; i < std::min(kBlocks, j + kWidth + 1); ++i) {
            for (int q = 0; q < kRows; ++q) {
                for (int p = 0; p < kRows; ++p) {
                    if (std::abs(p - q) <= kWidth) {
                        const double entry =
                            1.0 + i + 0.5 * j + 0.1 * std::min(p, q) * std::max(p, q);
                        small.column(j)((i - j) * kRows + p, q) = entry;
                        B(i * kRows + p, j * kRows + q) = entry;
                        B(j * kRows + q, i * kRows + p) = entry;
                    }
                }
            }
        }
    }
    Eigen::MatrixXd expected = A;
    for (int c = 0; c < kComponents; ++c) {
        for (Eigen::Index q = 0; q < B.cols(); ++q) {
            for (Eigen::Index p = 0; p < B.rows(); ++p) {
                expected(kComponents * p + c, kComponents * q + c) += 0.5 * B(p, q);
            }
        }
    }
    BlockBand sum = band(A);
    sum.add_per_component(small, 0.5);
    EXPECT_LT((sum.times(right_side()) - expected * right_side()).norm(), 1e-12);
}

TEST(BlockBand, RefusesAnIndefiniteMatrix) {
    Eigen::MatrixXd A = dense();
    A(10, 10) = -1.0;
    BlockBand factor = band(A);
    EXPECT_FALSE(factor.factorise());
}

}  // namespace
}  // namespace suture::mvs

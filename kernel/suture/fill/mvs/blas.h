#pragma once

#include <Eigen/Core>

namespace suture::mvs {

// The three operations in which nearly all time goes, by OpenBLAS on one thread: it takes the
// processor's widest instructions at run time, which Eigen can only at compile time. One thread,
// since results must not depend on how many there are; the parallelism is above.

using MatrixRef = Eigen::Ref<Eigen::MatrixXd, 0, Eigen::OuterStride<>>;
using ConstMatrixRef = Eigen::Ref<const Eigen::MatrixXd, 0, Eigen::OuterStride<>>;

/// The lower triangle of C += factor A A^T.
void add_gram(const ConstMatrixRef& A, MatrixRef C, double factor = 1.0);

/// C -= A B^T
void subtract_product(const ConstMatrixRef& A, const ConstMatrixRef& B, MatrixRef C);

/// X := X L^-T, with the lower triangle of L.
void divide_by_transposed(const ConstMatrixRef& L, MatrixRef X);

}  // namespace suture::mvs

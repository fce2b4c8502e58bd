#include "suture/fill/mvs/blas.h"

#include <cblas-openblas.h>

namespace suture::mvs {
namespace {

void on_one_thread() {
    [[maybe_unused]] static const bool done = [] {
        openblas_set_num_threads(1);
        return true;
    }();
}

blasint as_blas(Eigen::Index n) {
    return static_cast<blasint>(n);
}

}  // namespace

void add_gram(const ConstMatrixRef& J, MatrixRef C) {
    on_one_thread();
    cblas_dsyrk(CblasColMajor, CblasLower, CblasTrans, as_blas(C.rows()), as_blas(J.rows()), 1.0,
                J.data(), as_blas(J.outerStride()), 1.0, C.data(), as_blas(C.outerStride()));
}

void subtract_product(const ConstMatrixRef& A, const ConstMatrixRef& B, MatrixRef C) {
    on_one_thread();
    cblas_dgemm(CblasColMajor, CblasNoTrans, CblasTrans, as_blas(C.rows()), as_blas(C.cols()),
                as_blas(A.cols()), -1.0, A.data(), as_blas(A.outerStride()), B.data(),
                as_blas(B.outerStride()), 1.0, C.data(), as_blas(C.outerStride()));
}

void divide_by_transposed(const ConstMatrixRef& L, MatrixRef X) {
    on_one_thread();
    cblas_dtrsm(CblasColMajor, CblasRight, CblasLower, CblasTrans, CblasNonUnit, as_blas(X.rows()),
                as_blas(X.cols()), 1.0, L.data(), as_blas(L.outerStride()), X.data(),
                as_blas(X.outerStride()));
}

}  // namespace suture::mvs

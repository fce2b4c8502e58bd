#include "suture/fill/mvs/blas.h"

#include <cblas-openblas.h>

#include <mutex>

namespace suture::mvs {
namespace {

// OpenBLAS set to one thread. Its sequential build shares buffers between callers and has no locks:
// calls of that one must not overlap.
class Turn {
  public:
    Turn() {
        static const bool sequential = [] {
            openblas_set_num_threads(1);
            return openblas_get_parallel() == OPENBLAS_SEQUENTIAL;
        }();
        if (sequential) {
            lock_ = std::unique_lock(mutex());
        }
    }

  private:
    static std::mutex& mutex() {
        static std::mutex mutex;
        return mutex;
    }
    std::unique_lock<std::mutex> lock_;
};

blasint as_blas(Eigen::Index n) {
    return static_cast<blasint>(n);
}

}  // namespace

void add_gram(const ConstMatrixRef& A, MatrixRef C, double factor) {
    const Turn turn;
    cblas_dsyrk(CblasColMajor, CblasLower, CblasNoTrans, as_blas(C.rows()), as_blas(A.cols()),
                factor, A.data(), as_blas(A.outerStride()), 1.0, C.data(),
                as_blas(C.outerStride()));
}

void subtract_product(const ConstMatrixRef& A, const ConstMatrixRef& B, MatrixRef C) {
    const Turn turn;
    cblas_dgemm(CblasColMajor, CblasNoTrans, CblasTrans, as_blas(C.rows()), as_blas(C.cols()),
                as_blas(A.cols()), -1.0, A.data(), as_blas(A.outerStride()), B.data(),
                as_blas(B.outerStride()), 1.0, C.data(), as_blas(C.outerStride()));
}

void divide_by_transposed(const ConstMatrixRef& L, MatrixRef X) {
    const Turn turn;
    cblas_dtrsm(CblasColMajor, CblasRight, CblasLower, CblasTrans, CblasNonUnit, as_blas(X.rows()),
                as_blas(X.cols()), 1.0, L.data(), as_blas(L.outerStride()), X.data(),
                as_blas(X.outerStride()));
}

}  // namespace suture::mvs

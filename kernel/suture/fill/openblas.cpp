// The functions of OpenBLAS that fill methods call, passed on to the library, which is loaded at
// the first of these calls: closed forms need none of it.

#include "suture/platform/on_demand.h"

#include <cblas-openblas.h>

#include <cstdlib>

namespace {

// OpenBLAS knows processors by their model numbers, and gives those that are newer than itself the
// kernels of 2004: the instruction sets tell it better. Not those for AVX-512, which are younger
// than much of what is installed and have been wrong. Said before main, while there is one thread;
// what the user has set stands.
[[maybe_unused]] const bool kKernelsNamed = [] {
#ifdef __x86_64__
    if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma")) {
        return setenv("OPENBLAS_CORETYPE", "HASWELL", /*overwrite=*/0) == 0;
    }
#endif
    return false;
}();

template <class Function>
Function* openblas(const char* name) {
    return suture::function_on_demand<Function>("libopenblas.so.0", name);
}

}  // namespace

void openblas_set_num_threads(int count) {
    static const auto function = openblas<decltype(openblas_set_num_threads)>(__func__);
    function(count);
}

int openblas_get_parallel() {
    static const auto function = openblas<decltype(openblas_get_parallel)>(__func__);
    return function();
}

void cblas_dsyrk(CBLAS_ORDER order, CBLAS_UPLO uplo, CBLAS_TRANSPOSE trans, blasint n, blasint k,
                 double alpha, const double* a, blasint lda, double beta, double* c, blasint ldc) {
    static const auto function = openblas<decltype(cblas_dsyrk)>(__func__);
    function(order, uplo, trans, n, k, alpha, a, lda, beta, c, ldc);
}

void cblas_dgemm(CBLAS_ORDER order, CBLAS_TRANSPOSE trans_a, CBLAS_TRANSPOSE trans_b, blasint m,
                 blasint n, blasint k, double alpha, const double* a, blasint lda, const double* b,
                 blasint ldb, double beta, double* c, blasint ldc) {
    static const auto function = openblas<decltype(cblas_dgemm)>(__func__);
    function(order, trans_a, trans_b, m, n, k, alpha, a, lda, b, ldb, beta, c, ldc);
}

void cblas_dtrsm(CBLAS_ORDER order, CBLAS_SIDE side, CBLAS_UPLO uplo, CBLAS_TRANSPOSE trans,
                 CBLAS_DIAG diag, blasint m, blasint n, double alpha, const double* a, blasint lda,
                 double* b, blasint ldb) {
    static const auto function = openblas<decltype(cblas_dtrsm)>(__func__);
    function(order, side, uplo, trans, diag, m, n, alpha, a, lda, b, ldb);
}

#include "suture/fill/mvs/block_cholesky.h"

#include "suture/base/contract.h"
#include "suture/fill/mvs/blas.h"

#include <Eigen/Cholesky>

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

namespace suture::mvs {

BlockBand::BlockBand(int blocks, int size, int width)
    : columns_(static_cast<std::size_t>(blocks)), size_(size), width_(width) {
    for (int j = 0; j < blocks; ++j) {
        column(j) = Eigen::MatrixXd::Zero(reach(j) * size, size);
    }
}

int BlockBand::reach(int j) const {
    return std::min(width_, blocks() - 1 - j) + 1;
}

void BlockBand::add_per_component(const BlockBand& other, double factor) {
    const int components = size_ / other.size_;
    SUTURE_EXPECTS(other.blocks() == blocks() && other.width_ == width_ &&
                   components * other.size_ == size_);
    for (int j = 0; j < blocks(); ++j) {
        const Eigen::MatrixXd& from = other.column(j);
        Eigen::MatrixXd& to = column(j);
        for (int q = 0; q < other.size_; ++q) {
            const int first = std::max(0, q - width_);
            const int last = std::min(other.size_ - 1, q + width_);
            for (int i = 0; i < reach(j); ++i) {
                for (int p = first; p <= last; ++p) {
                    const double entry = factor * from(i * other.size_ + p, q);
                    for (int c = 0; c < components; ++c) {
                        to(i * size_ + components * p + c, components * q + c) += entry;
                    }
                }
            }
        }
    }
}

Eigen::MatrixXd BlockBand::times(const Eigen::MatrixXd& x) const {
    Eigen::MatrixXd y = Eigen::MatrixXd::Zero(x.rows(), x.cols());
    for (int j = 0; j < blocks(); ++j) {
        const Eigen::MatrixXd& A = column(j);
        const int below = static_cast<int>(A.rows()) - size_;
        const auto own = x.middleRows(j * size_, size_);
        y.middleRows(j * size_, size_) +=
            A.topRows(size_).selfadjointView<Eigen::Lower>() * own +
            A.bottomRows(below).transpose() * x.middleRows((j + 1) * size_, below);
        y.middleRows((j + 1) * size_, below) += A.bottomRows(below) * own;
    }
    return y;
}

// For each block column the factor of its own block, its panel, and what the panel takes from the
// columns after it.
double BlockBand::work(int blocks, int size, int width) {
    const double per_column = 1.0 / 6.0 + 0.5 * width + 0.5 * width * width;
    return per_column * blocks * std::pow(size, 3);
}

bool BlockBand::factorise() {
    for (int j = 0; j < blocks(); ++j) {
        Eigen::MatrixXd& A = column(j);
        Eigen::Ref<Eigen::MatrixXd> diagonal = A.topRows(size_);
        const Eigen::LLT<Eigen::Ref<Eigen::MatrixXd>> llt(diagonal);
        if (llt.info() != Eigen::Success) {
            return false;
        }
        const int below = reach(j) - 1;
        if (below == 0) {
            continue;
        }
        auto panel = A.bottomRows(below * size_);
        divide_by_transposed(diagonal, panel);
        tbb::parallel_for(1, below + 1, [&](int k) {
            const auto own = A.middleRows(k * size_, size_);
            const auto rest = (below - k) * size_;
            add_gram(own, column(j + k).topRows(size_), -1.0);
            if (rest > 0) {
                subtract_product(A.bottomRows(rest), own, column(j + k).middleRows(size_, rest));
            }
        });
    }
    return true;
}

Eigen::VectorXd BlockBand::solve(const Eigen::VectorXd& b) const {
    Eigen::VectorXd x = b;
    for (int j = 0; j < blocks(); ++j) {
        const Eigen::MatrixXd& L = column(j);
        const auto below = L.rows() - size_;
        auto own = x.segment(j * size_, size_);
        L.topRows(size_).triangularView<Eigen::Lower>().solveInPlace(own);
        x.segment((j + 1) * size_, below).noalias() -= L.bottomRows(below) * own;
    }
    for (int j = blocks() - 1; j >= 0; --j) {
        const Eigen::MatrixXd& L = column(j);
        const auto below = L.rows() - size_;
        auto own = x.segment(j * size_, size_);
        own.noalias() -= L.bottomRows(below).transpose() * x.segment((j + 1) * size_, below);
        L.topRows(size_).triangularView<Eigen::Lower>().transpose().solveInPlace(own);
    }
    return x;
}

}  // namespace suture::mvs

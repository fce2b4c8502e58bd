#include "suture/fill/algebraic/least_distance.h"

#include <Eigen/QR>

#include <vector>

namespace suture::algebraic {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double kRounding = 1e-12;

VectorXd solve_passive(const MatrixXd& A, const VectorXd& b, const std::vector<Index>& passive) {
    const MatrixXd columns = A(Eigen::all, passive);
    return columns.colPivHouseholderQr().solve(b);
}

/// min |A y - b| with y >= 0 (Lawson & Hanson, algorithm NNLS).
VectorXd nonnegative_least_squares(const MatrixXd& A, const VectorXd& b) {
    VectorXd y = VectorXd::Zero(A.cols());
    std::vector<Index> passive;
    std::vector<bool> is_passive(static_cast<std::size_t>(A.cols()), false);
    const Index most_steps = 3 * A.cols();
    for (Index step = 0; step < most_steps; ++step) {
        VectorXd w = A.transpose() * (b - A * y);
        for (const Index i : passive) {
            w[i] = 0.0;
        }
        Index enter = 0;
        if (w.maxCoeff(&enter) <= kRounding || is_passive[static_cast<std::size_t>(enter)]) {
            break;
        }
        passive.push_back(enter);
        is_passive[static_cast<std::size_t>(enter)] = true;
        VectorXd z = solve_passive(A, b, passive);
        while (z.size() > 0 && z.minCoeff() <= 0.0) {
            double alpha = 1.0;
            for (std::size_t k = 0; k < passive.size(); ++k) {
                const auto n = static_cast<Index>(k);
                if (z[n] <= 0.0) {
                    alpha = std::min(alpha, y[passive[k]] / (y[passive[k]] - z[n]));
                }
            }
            std::vector<Index> kept;
            for (std::size_t k = 0; k < passive.size(); ++k) {
                const Index i = passive[k];
                y[i] += alpha * (z[static_cast<Index>(k)] - y[i]);
                if (y[i] > kRounding) {
                    kept.push_back(i);
                } else {
                    y[i] = 0.0;
                    is_passive[static_cast<std::size_t>(i)] = false;
                }
            }
            passive = kept;
            z = passive.empty() ? VectorXd() : solve_passive(A, b, passive);
        }
        y.setZero();
        for (std::size_t k = 0; k < passive.size(); ++k) {
            y[passive[k]] = z[static_cast<Index>(k)];
        }
    }
    return y;
}

}  // namespace

std::optional<VectorXd> least_distance(const MatrixXd& G, const VectorXd& h) {
    const Index n = G.cols();
    MatrixXd E(n + 1, G.rows());
    E << G.transpose(), h.transpose();
    const VectorXd f = VectorXd::Unit(n + 1, n);
    const VectorXd r = E * nonnegative_least_squares(E, f) - f;
    if (r.norm() <= std::sqrt(kRounding) || !(r[n] < 0.0)) {
        return std::nullopt;
    }
    return VectorXd(r.head(n) / -r[n]);
}

}  // namespace suture::algebraic

#include "suture/fill/algebraic/least_distance.h"

#include <Eigen/QR>

#include <cmath>
#include <limits>
#include <vector>

namespace suture::algebraic {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// How far a condition, with a gradient of length 1, may be missed.
constexpr double kRounding = 1e-12;
/// A gradient this near to the span of the active ones depends on them.
constexpr double kDependent = 1e-10;
/// For each unknown: far more than conditions enter and leave; rounding could go on for ever.
constexpr Index kMostSteps = 50;

/// The dual active set method for min |y|^2 / 2 with G y >= h, the rows of G of length 1: y is
/// always the optimum under the active conditions, whose multipliers are never negative. The most
/// violated condition enters, others leave where their multiplier would become negative; |y| grows
/// with every step.
class DualActiveSet {
  public:
    DualActiveSet(const MatrixXd& G, const VectorXd& h)
        : G_(G), h_(h), y_(VectorXd::Zero(G.cols())) {}

    std::optional<VectorXd> solve(const Progress& progress) {
        for (;;) {
            Index worst = 0;
            const double violation = (h_ - G_ * y_).maxCoeff(&worst);
            if (violation <= kRounding * (1.0 + y_.norm())) {
                return y_;
            }
            if (progress.cancelled() || steps_ > kMostSteps * G_.cols() || !enter(worst)) {
                return std::nullopt;
            }
        }
    }

  private:
    const MatrixXd& G_;
    const VectorXd& h_;
    VectorXd y_;
    std::vector<Index> active_;
    std::vector<double> multipliers_;
    Index steps_ = 0;

    void leave(std::size_t k) {
        active_.erase(active_.begin() + static_cast<std::ptrdiff_t>(k));
        multipliers_.erase(multipliers_.begin() + static_cast<std::ptrdiff_t>(k));
    }

    /// Moves until the condition holds; false if it contradicts the active ones.
    bool enter(Index entering) {
        const VectorXd g = G_.row(entering).transpose();
        double own = 0.0;  // its multiplier
        for (;; ++steps_) {
            // g = N r + z, z perpendicular to the active gradients N.
            VectorXd r(0);
            VectorXd z = g;
            if (!active_.empty()) {
                const MatrixXd N = G_(active_, Eigen::all).transpose();
                r = N.householderQr().solve(g);
                z -= N * r;
            }
            double step = std::numeric_limits<double>::infinity();
            std::size_t leaving = 0;
            for (std::size_t k = 0; k < active_.size(); ++k) {
                const double rate = r[static_cast<Index>(k)];
                if (rate > 0.0 && multipliers_[k] / rate < step) {
                    step = multipliers_[k] / rate;
                    leaving = k;
                }
            }
            const bool moves = z.norm() > kDependent;
            const double full = moves ? (h_[entering] - g.dot(y_)) / z.squaredNorm()
                                      : std::numeric_limits<double>::infinity();
            if (!moves && !std::isfinite(step)) {
                return false;
            }
            const double t = std::min(step, full);
            if (moves) {
                y_ += t * z;
            }
            own += t;
            for (std::size_t k = 0; k < active_.size(); ++k) {
                multipliers_[k] -= t * r[static_cast<Index>(k)];
            }
            if (full <= step) {
                active_.push_back(entering);
                multipliers_.push_back(own);
                return true;
            }
            leave(leaving);
        }
    }
};

}  // namespace

std::optional<VectorXd> least_distance(const MatrixXd& G, const VectorXd& h,
                                       const Progress& progress) {
    const VectorXd lengths = G.rowwise().norm().cwiseMax(std::numeric_limits<double>::min());
    const MatrixXd rows = lengths.cwiseInverse().asDiagonal() * G;
    const VectorXd right = h.cwiseQuotient(lengths);
    return DualActiveSet(rows, right).solve(progress);
}

}  // namespace suture::algebraic

#pragma once

#include "suture/fill/manifold/border_samples.h"

#include <Eigen/SparseCore>

#include <vector>

namespace suture::manifold {

/// Least squares in the three coordinates of all points together.
class BorderSystem {
  public:
    explicit BorderSystem(int count) : unknowns_(3 * count) {}

    /// What is only wished for is weighed against the energy; all else comes before it.
    enum class Kind { Demand, Wish };

    /// Adds the residual sum_k gradient_k . P_k - value.
    void add(const BorderRow& row, const Eigen::MatrixXd& gradient, double value, double weight,
             Kind kind = Kind::Demand);

    /// Asks for S itself at a place.
    void add_point(const BorderRow& row, const Eigen::Vector3d& point, double weight,
                   Kind kind = Kind::Demand);

    /// The least energy and the most wishes among the best approximations, by the method of
    /// multipliers: what is left of the residuals is added to the values and the same matrix
    /// solved again.
    ///
    /// Refuses  a system that cannot be factorised.
    [[nodiscard]] Result<Eigen::Matrix3Xd> solve(const Eigen::SparseMatrix<double>& energy,
                                                 int steps = kMultiplierSteps) const;

  private:
    /// Solutions by the method of multipliers.
    static constexpr int kMultiplierSteps = 8;

    Eigen::Index unknowns_;
    std::vector<Eigen::Triplet<double>> entries_;
    std::vector<double> values_;
    std::vector<double> demanded_;  ///< 1 or 0

    [[nodiscard]] Eigen::SparseMatrix<double> in_space(
        const Eigen::SparseMatrix<double>& energy) const;
};

}  // namespace suture::manifold

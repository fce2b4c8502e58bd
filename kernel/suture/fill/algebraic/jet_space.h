#pragma once

#include "suture/fill/algebraic/partition.h"
#include "suture/fill/algebraic/space.h"

#include <Eigen/Core>

#include <vector>

namespace suture::algebraic {

/// What G^k asks of a polynomial at a point of a side, in unit coordinates.
struct SideJet {
    Eigen::Vector3d point;
    Eigen::Vector3d normal;
    Eigen::Vector3d inward;
    Eigen::Matrix3d curvature;  ///< second fundamental form, as in RibbonPoint
};

/// The jets along a side, met with G^k, k <= 2.
struct SideJets {
    std::vector<SideJet> jets;
    int k = 1;
};

/// The piecewise polynomials of one degree that join with G^k between cells, and at the sides as
/// nearly as a tolerance asks for.
///
/// Joins between cells are the paper's: g_b = g_a + alpha pi^(k+1), exact. At a side Definition
/// 2.1 (rescaling continuity) is taken at points: g and its slope along `inward` vanish there, and
/// for k = 2 its normal curvature is the neighbour's. By Theorem 2.2 that is g = gamma f + beta
/// h^(k+1) wherever the neighbour has a polynomial f and h any surface across it.
class JetSpace {
  public:
    JetSpace(const Partition& partition, const std::vector<SideJets>& sides,
             const std::vector<Polynomial<double>>& planes, int interface_k, int degree);

    /// All members that miss the sides by no more than `most`, each with its miss: the root mean
    /// square of what should vanish, for coefficients of length 1.
    [[nodiscard]] Space within(double most) const;

    [[nodiscard]] int rows() const { return rows_; }
    [[nodiscard]] int columns() const { return static_cast<int>(joined_.cols()); }

  private:
    int degree_;
    Eigen::MatrixXd joined_;  ///< orthonormal columns: cells that join
    Eigen::VectorXd misses_;  ///< of the columns of `directions_`, falling
    Eigen::MatrixXd directions_;
    int rows_ = 0;
};

}  // namespace suture::algebraic

#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <vector>

namespace suture::tube {

/// Energies and what is solved with them: next to corners the intervals are so short that double
/// precision would lose the smooth part of a surface in the rounding of their share.
using Real = long double;
using RealMatrix = Eigen::Matrix<Real, Eigen::Dynamic, Eigen::Dynamic>;
using RealSparse = Eigen::SparseMatrix<Real>;
using RealVector = Eigen::Matrix<Real, Eigen::Dynamic, 1>;

/// Quadratic B-splines around a closed curve: as many columns as knot intervals. An interval of
/// zero length is a double knot, where a row passes through its column and may have a corner.
///
/// On interval k, from knots()[k + 2] to knots()[k + 3], the columns k, k + 1 and k + 2 live, all
/// counted around.
class Ring {
  public:
    explicit Ring(std::vector<double> intervals);

    [[nodiscard]] int columns() const { return static_cast<int>(intervals_.size()); }
    [[nodiscard]] const std::vector<double>& intervals() const { return intervals_; }
    [[nodiscard]] double length() const { return knots_[knots_.size() - 3]; }
    /// The knot at which interval k begins.
    [[nodiscard]] double start(int k) const { return knots_[static_cast<std::size_t>(k) + 2]; }
    [[nodiscard]] double interval(int k) const {
        return intervals_[static_cast<std::size_t>(wrapped(k))];
    }
    [[nodiscard]] int wrapped(int column) const {
        const int m = columns();
        return (column % m + m) % m;
    }

    /// Basis functions of columns first, first + 1, first + 2 (to be wrapped) and derivatives.
    struct Local {
        int first = 0;
        Eigen::MatrixXd basis;  ///< (orders + 1) x 3
    };
    /// v in [0, length]; at a knot the interval after it, at the end the last one.
    [[nodiscard]] Local at(double v, int orders) const;
    /// On a given interval, v may be either of its ends.
    [[nodiscard]] Local on(int interval, double v, int orders) const;

    /// A column at a double knot: with continuous tangents it is `before` times the column before
    /// it plus (1 - before) times the one after it.
    struct Double {
        int column = 0;
        double before = 0.5;
    };
    [[nodiscard]] const std::vector<Double>& doubles() const { return doubles_; }

    /// Integrals of products of b-th derivatives of the basis functions, exact.
    [[nodiscard]] RealSparse gram(int b) const;

  private:
    std::vector<double> intervals_;
    std::vector<double> knots_;  ///< unwrapped: two intervals more on either side
    std::vector<Double> doubles_;
};

/// The same for the clamped cubic knots across.
[[nodiscard]] RealMatrix cubic_gram(const std::vector<double>& knots, int a);

}  // namespace suture::tube

#pragma once

#include "suture/fill/algebraic/polynomial.h"

#include <Eigen/Core>

namespace suture::algebraic {

/// All monomials up to a degree at one point: values, first derivatives (x, y, z), second
/// derivatives (xx, yy, zz, xy, xz, yz), one row for each.
struct MonomialJets {
    Eigen::RowVectorXd value;
    Eigen::Matrix<double, 3, Eigen::Dynamic> first;
    Eigen::Matrix<double, 6, Eigen::Dynamic> second;
};
[[nodiscard]] MonomialJets monomial_jets(int degree, const Eigen::Vector3d& x);

/// A polynomial's value and gradient.
struct ValueAndGradient {
    double value = 0.0;
    Eigen::Vector3d gradient = Eigen::Vector3d::Zero();
};
[[nodiscard]] ValueAndGradient evaluate(const Polynomial<double>& p, const Eigen::Vector3d& x);

/// The second fundamental form of the level set p = const through x, as in RibbonPoint: for the
/// normal along the gradient.
[[nodiscard]] Eigen::Matrix3d curvature(const Polynomial<double>& p, const Eigen::Vector3d& x);

/// p(A x + b)
[[nodiscard]] Polynomial<double> moved(const Polynomial<double>& p, const Eigen::Matrix3d& A,
                                       const Eigen::Vector3d& b);

[[nodiscard]] inline Eigen::Map<const Eigen::VectorXd> coefficients(const Polynomial<double>& p) {
    return {p.coefficients.data(), static_cast<Eigen::Index>(p.coefficients.size())};
}

}  // namespace suture::algebraic

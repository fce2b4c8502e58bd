#include "suture/fill/algebraic/jets.h"

namespace suture::algebraic {
namespace {

/// x^n and its first two derivatives for n = 0 .. degree.
Eigen::Matrix3Xd powers(int degree, double x) {
    Eigen::Matrix3Xd p = Eigen::Matrix3Xd::Zero(3, degree + 1);
    p(0, 0) = 1.0;
    for (int n = 1; n <= degree; ++n) {
        p(0, n) = p(0, n - 1) * x;
        p(1, n) = n * p(0, n - 1);
        p(2, n) = n * p(1, n - 1);
    }
    return p;
}

}  // namespace

MonomialJets monomial_jets(int degree, const Eigen::Vector3d& x) {
    const Eigen::Matrix3Xd X = powers(degree, x.x());
    const Eigen::Matrix3Xd Y = powers(degree, x.y());
    const Eigen::Matrix3Xd Z = powers(degree, x.z());
    const int count = monomial_count(degree);
    MonomialJets jets{Eigen::RowVectorXd(count), Eigen::Matrix3Xd(3, count),
                      Eigen::Matrix<double, 6, Eigen::Dynamic>(6, count)};
    int n = 0;
    for (const Monomial& m : monomials(degree)) {
        const auto at = [&](int dx, int dy, int dz) {
            return X(dx, m.i) * Y(dy, m.j) * Z(dz, m.k);
        };
        jets.value[n] = at(0, 0, 0);
        jets.first.col(n) << at(1, 0, 0), at(0, 1, 0), at(0, 0, 1);
        jets.second.col(n) << at(2, 0, 0), at(0, 2, 0), at(0, 0, 2), at(1, 1, 0), at(1, 0, 1),
            at(0, 1, 1);
        ++n;
    }
    return jets;
}

ValueAndGradient evaluate(const Polynomial<double>& p, const Eigen::Vector3d& x) {
    // Horner's scheme in every variable would save little: degrees are below ten.
    const Eigen::Matrix3Xd X = powers(p.degree, x.x());
    const Eigen::Matrix3Xd Y = powers(p.degree, x.y());
    const Eigen::Matrix3Xd Z = powers(p.degree, x.z());
    ValueAndGradient result;
    std::size_t n = 0;
    for (int d = 0; d <= p.degree; ++d) {
        for (int rest = 0; rest <= d; ++rest) {
            for (int k = 0; k <= rest; ++k) {
                const int i = d - rest;
                const int j = rest - k;
                const double c = p.coefficients[n++];
                result.value += c * X(0, i) * Y(0, j) * Z(0, k);
                result.gradient +=
                    c * Eigen::Vector3d(X(1, i) * Y(0, j) * Z(0, k), X(0, i) * Y(1, j) * Z(0, k),
                                        X(0, i) * Y(0, j) * Z(1, k));
            }
        }
    }
    return result;
}

Eigen::Matrix3d curvature(const Polynomial<double>& p, const Eigen::Vector3d& x) {
    const MonomialJets jets = monomial_jets(p.degree, x);
    const Eigen::Vector3d gradient = jets.first * coefficients(p);
    const Eigen::Vector3d normal = gradient.normalized();
    const Eigen::Matrix<double, 6, 1> h = jets.second * coefficients(p);
    Eigen::Matrix3d hessian;
    hessian << h[0], h[3], h[4], h[3], h[1], h[5], h[4], h[5], h[2];
    const Eigen::Matrix3d along = Eigen::Matrix3d::Identity() - normal * normal.transpose();
    return -along * hessian * along / gradient.norm();
}

Polynomial<double> moved(const Polynomial<double>& p, const Eigen::Matrix3d& A,
                         const Eigen::Vector3d& b) {
    std::array<Polynomial<double>, 3> by;
    for (int axis = 0; axis < 3; ++axis) {
        by[static_cast<std::size_t>(axis)] =
            Polynomial<double>::linear({A(axis, 0), A(axis, 1), A(axis, 2)}, b[axis]);
    }
    return substitute(p, by);
}

}  // namespace suture::algebraic

#include "suture/fill/algebraic/frustum.h"

#include "suture/fill/algebraic/jets.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace suture::algebraic {
namespace {

using Eigen::MatrixXd;
using Trinomial = Polynomial<double>;

double binomial(int n, int k) {
    double value = 1.0;
    for (int i = 1; i <= k; ++i) {
        value = value * (n - k + i) / i;
    }
    return k < 0 || k > n ? 0.0 : value;
}

/// The products of three linear forms that stand for the monomials, in the monomials' order.
std::vector<Trinomial> products(const std::array<Trinomial, 3>& forms, int degree) {
    std::vector<Trinomial> result;
    for (const Monomial& m : monomials(degree)) {
        if (m.degree() == 0) {
            result.emplace_back(1.0);
            continue;
        }
        Monomial before = m;
        const std::size_t axis = m.i > 0 ? 0 : m.j > 0 ? 1 : 2;
        --(axis == 0 ? before.i : axis == 1 ? before.j : before.k);
        result.push_back(result[static_cast<std::size_t>(index_of(before))] * forms[axis]);
    }
    return result;
}

std::array<Trinomial, 3> forms(const Eigen::Matrix3d& A, const Eigen::Vector3d& b) {
    std::array<Trinomial, 3> result;
    for (int axis = 0; axis < 3; ++axis) {
        result[static_cast<std::size_t>(axis)] =
            Trinomial::linear({A(axis, 0), A(axis, 1), A(axis, 2)}, b[axis]);
    }
    return result;
}

/// Coefficients of p(centre + x) from those of p.
MatrixXd shift_map(const Eigen::Vector3d& centre, int degree) {
    const int count = monomial_count(degree);
    MatrixXd map = MatrixXd::Zero(count, count);
    const auto shifted = products(forms(Eigen::Matrix3d::Identity(), centre), degree);
    for (int n = 0; n < count; ++n) {
        const auto& c = shifted[static_cast<std::size_t>(n)].coefficients;
        for (std::size_t row = 0; row < c.size(); ++row) {
            map(static_cast<Eigen::Index>(row), n) = c[row];
        }
    }
    return map;
}

/// The Bernstein coefficients of t^l of degree d over [t0, t1]: its polar form at the ends.
Eigen::VectorXd power_in_bernstein(int l, int d, double t0, double t1) {
    Eigen::VectorXd c = Eigen::VectorXd::Zero(d + 1);
    for (int m = 0; m <= d; ++m) {
        for (int j = std::max(0, l - (d - m)); j <= std::min(l, m); ++j) {
            c[m] += binomial(m, j) * binomial(d - m, l - j) * std::pow(t1, j) *
                    std::pow(t0, l - j) / binomial(d, l);
        }
    }
    return c;
}

}  // namespace

MatrixXd bernstein_map(const Frustum& frustum, int degree) {
    const int count = monomial_count(degree);
    const int layer = layer_size(degree);
    const int first = monomial_count(degree - 1);  // of the monomials of full degree
    const auto in_b = products(forms(frustum.directions, Eigen::Vector3d::Zero()), degree);
    std::vector<Trinomial> raise = {Trinomial(1.0)};  // (b0 + b1 + b2)^n
    for (int n = 1; n <= degree; ++n) {
        raise.push_back(raise.back() * Trinomial::linear({1.0, 1.0, 1.0}, 0.0));
    }
    const std::vector<Monomial> all = monomials(degree);
    MatrixXd map(static_cast<Eigen::Index>(degree + 1) * layer, count);
    for (int n = 0; n < count; ++n) {
        const int l = all[static_cast<std::size_t>(n)].degree();
        const Trinomial full =
            in_b[static_cast<std::size_t>(n)] * raise[static_cast<std::size_t>(degree - l)];
        Eigen::VectorXd b(layer);
        for (int r = 0; r < layer; ++r) {
            const Monomial& m = all[static_cast<std::size_t>(first + r)];
            const double weight = binomial(degree, m.i) * binomial(degree - m.i, m.j);
            b[r] = full.coefficients[static_cast<std::size_t>(first + r)] / weight;
        }
        const Eigen::VectorXd t = power_in_bernstein(l, degree, frustum.t0, frustum.t1);
        for (int m = 0; m <= degree; ++m) {
            map.block(static_cast<Eigen::Index>(m) * layer, n, layer, 1) = t[m] * b;
        }
    }
    return map * shift_map(frustum.centre, degree);
}

std::vector<Frustum> quartered(const Frustum& frustum) {
    const Eigen::Matrix3d& d = frustum.directions;
    const Eigen::Vector3d m01 = 0.5 * (d.col(0) + d.col(1));
    const Eigen::Vector3d m12 = 0.5 * (d.col(1) + d.col(2));
    const Eigen::Vector3d m20 = 0.5 * (d.col(2) + d.col(0));
    std::vector<Frustum> quarters(4, frustum);
    quarters[0].directions << d.col(0), m01, m20;
    quarters[1].directions << m01, d.col(1), m12;
    quarters[2].directions << m20, m12, d.col(2);
    quarters[3].directions << m01, m12, m20;
    return quarters;
}

Proof prove(const Polynomial<double>& p, const Frustum& frustum, double sign, double margin,
            int depth) {
    const int d = p.degree;
    const int layer = layer_size(d);
    const Eigen::VectorXd all = sign * (bernstein_map(frustum, d) * coefficients(p));
    const Eigen::Map<const MatrixXd> c(all.data(), layer, d + 1);
    Proof proof;
    int below = 0;  // layers that are negative from t0 on
    while (below <= d && c.col(below).maxCoeff() < -margin) {
        ++below;
    }
    int above = d;
    while (above >= 0 && c.col(above).minCoeff() > margin) {
        --above;
    }
    proof.single = below > 0 && above < d && above <= below;
    proof.slope = std::numeric_limits<double>::infinity();
    for (int m = 0; m < d; ++m) {
        proof.slope = std::min(
            proof.slope, d * (c.col(m + 1) - c.col(m)).minCoeff() / (frustum.t1 - frustum.t0));
    }
    if ((proof.single && proof.slope > 0.0) || depth == 0) {
        return proof;
    }
    Proof parts{true, std::numeric_limits<double>::infinity()};
    for (const Frustum& quarter : quartered(frustum)) {
        const Proof part = prove(p, quarter, sign, margin, proof.single ? 0 : depth - 1);
        parts.single = parts.single && part.single;
        parts.slope = std::min(parts.slope, part.slope);
        if (!parts.single) {
            return parts;
        }
    }
    return parts;
}

}  // namespace suture::algebraic

#include "suture/fill/mvs/variation.h"

#include <Eigen/Geometry>

#include <array>
#include <cmath>

namespace suture::mvs {
namespace {

// A symmetric index pair (a, b) is stored at a + b, a triple (a, b, c) at a + b + c: both count how
// often the second direction occurs.
constexpr int kPairs = 3;
constexpr int kTriples = 4;
constexpr std::array<double, kTriples> kMultiplicity = {1.0, 3.0, 3.0, 1.0};
using Triple = std::array<int, 3>;
constexpr std::array<Triple, kTriples> kIndices = {{{0, 0, 0}, {0, 0, 1}, {0, 1, 1}, {1, 1, 1}}};

// The surface in parameters that are orthonormal at the point: Y_1 = a X_u, Y_2 = b X_u + c X_v.
struct LocalFrame {
    double a, b, c;
    Eigen::Vector3d e1, e2, n;
    double area;
};

LocalFrame local_frame(const Derivatives& X) {
    LocalFrame f;
    const double length = X.col(0).norm();
    f.a = 1.0 / length;
    f.e1 = f.a * X.col(0);
    const double shear = f.e1.dot(X.col(1));
    const Eigen::Vector3d rest = X.col(1) - shear * f.e1;
    const double height = rest.norm();
    f.c = 1.0 / height;
    f.b = -shear * f.a * f.c;
    f.e2 = f.c * rest;
    f.n = f.e1.cross(f.e2);
    f.area = length * height;
    return f;
}

// Rows of derivatives with respect to the orthonormal parameters; T is a row of nine (per
// component) and the result likewise.
template <class Row>
void to_local(const LocalFrame& f, const Row& X, Row& Y) {
    const double a = f.a;
    const double b = f.b;
    const double c = f.c;
    Y[0] = a * X[0];
    Y[1] = b * X[0] + c * X[1];
    Y[2] = a * a * X[2];
    Y[3] = a * (b * X[2] + c * X[3]);
    Y[4] = b * b * X[2] + 2.0 * b * c * X[3] + c * c * X[4];
    Y[5] = a * a * a * X[5];
    Y[6] = a * a * (b * X[5] + c * X[6]);
    Y[7] = a * (b * b * X[5] + 2.0 * b * c * X[6] + c * c * X[7]);
    Y[8] = b * b * b * X[5] + 3.0 * b * b * c * X[6] + 3.0 * b * c * c * X[7] + c * c * c * X[8];
}

// The transpose of to_local: what acts on Y, as acting on X.
template <class Row>
void from_local(const LocalFrame& f, const Row& y, Row& x) {
    const double a = f.a;
    const double b = f.b;
    const double c = f.c;
    x[0] = a * y[0] + b * y[1];
    x[1] = c * y[1];
    x[2] = a * a * y[2] + a * b * y[3] + b * b * y[4];
    x[3] = a * c * y[3] + 2.0 * b * c * y[4];
    x[4] = c * c * y[4];
    x[5] = a * a * a * y[5] + a * a * b * y[6] + a * b * b * y[7] + b * b * b * y[8];
    x[6] = a * a * c * y[6] + 2.0 * a * b * c * y[7] + 3.0 * b * b * c * y[8];
    x[7] = a * c * c * y[7] + 3.0 * b * c * c * y[8];
    x[8] = c * c * c * y[8];
}

using Nine = std::array<double, 9>;

// Components of the local derivatives along n, e1, e2.
struct LocalJet {
    LocalFrame frame;
    std::array<double, kPairs> h;                       // n . Y_ab: the second fundamental form
    std::array<std::array<double, kPairs>, 2> tau;      // e_m . Y_ab: the Christoffel symbols
    std::array<double, kTriples> third;                 // n . Y_abc
    std::array<std::array<double, kTriples>, 2> sigma;  // e_m . Y_abc
    std::array<double, kTriples> T;                     // grad II
};

LocalJet local_jet(const Derivatives& X) {
    LocalJet j;
    j.frame = local_frame(X);
    const auto along = [&](const Eigen::Vector3d& direction) {
        const Eigen::Matrix<double, 1, 9> row = direction.transpose() * X;
        Nine x, y;
        for (int d = 0; d < 9; ++d) {
            x[static_cast<std::size_t>(d)] = row[d];
        }
        to_local(j.frame, x, y);
        return y;
    };
    const Nine n = along(j.frame.n);
    const std::array<Nine, 2> e = {along(j.frame.e1), along(j.frame.e2)};
    for (std::size_t p = 0; p < kPairs; ++p) {
        j.h[p] = n[2 + p];
        j.tau[0][p] = e[0][2 + p];
        j.tau[1][p] = e[1][2 + p];
    }
    for (std::size_t t = 0; t < kTriples; ++t) {
        j.third[t] = n[5 + t];
        j.sigma[0][t] = e[0][5 + t];
        j.sigma[1][t] = e[1][5 + t];
    }
    // grad_c II_ab = n . Y_abc - sum over the three ways to split abc into a pair and a rest
    for (std::size_t t = 0; t < kTriples; ++t) {
        const Triple& i = kIndices[t];
        double value = j.third[t];
        for (std::size_t k = 0; k < 3; ++k) {
            const auto rest = static_cast<std::size_t>(i[k]);
            const std::size_t pair = t - rest;
            for (std::size_t m = 0; m < 2; ++m) {
                value -= j.tau[m][pair] * j.h[m + rest];
            }
        }
        j.T[t] = value;
    }
    return j;
}

// A residual's derivatives with respect to the components of dY along n, e1, e2.
struct LocalGradient {
    Nine n{};
    std::array<Nine, 2> e{};  // e[m][d]: along e_m
};

// How T_abc changes; see docs/methods/mvs.md, "derivatives".
LocalGradient gradient_of(const LocalJet& j, std::size_t t) {
    LocalGradient g;
    const auto metric = [&](std::size_t a, std::size_t b, double factor) {
        // dg_ab = e_b . dY_a + e_a . dY_b
        g.e[b][a] += factor;
        g.e[a][b] += factor;
    };
    const Triple& i = kIndices[t];
    g.n[5 + t] += 1.0;
    for (std::size_t m = 0; m < 2; ++m) {
        g.n[m] -= j.sigma[m][t];  // dn = - sum (n . dY_m) e_m
    }
    for (std::size_t k = 0; k < 3; ++k) {
        const auto rest = static_cast<std::size_t>(i[k]);
        const std::size_t pair = t - rest;
        for (std::size_t m = 0; m < 2; ++m) {
            const double h = j.h[m + rest];
            const double tau = j.tau[m][pair];
            // dtau^m = e_m . dY_pair + Y_pair . dY_m
            g.e[m][2 + pair] -= h;
            g.n[m] -= h * j.h[pair];
            for (std::size_t l = 0; l < 2; ++l) {
                g.e[l][m] -= h * j.tau[l][pair];
            }
            // dh_{m rest} = n . dY_{m rest} - sum (n . dY_l) tau^l_{m rest}
            g.n[2 + m + rest] -= tau;
            for (std::size_t l = 0; l < 2; ++l) {
                g.n[l] += tau * j.tau[l][m + rest];
            }
            // the inverse metric between tau and h: dg^{lm} = - dg_lm
            for (std::size_t l = 0; l < 2; ++l) {
                metric(l, m, j.tau[l][pair] * h);
            }
        }
        // the orthonormal frame: dA = - dg / 2
        for (std::size_t l = 0; l < 2; ++l) {
            metric(rest, l, -0.5 * j.T[pair + l]);
        }
    }
    // the area element: d sqrt(area) = sqrt(area) tr(dg) / 4
    for (std::size_t m = 0; m < 2; ++m) {
        metric(m, m, 0.25 * j.T[t]);
    }
    return g;
}

}  // namespace

Eigen::Vector4d curvature_variation(const Derivatives& X) {
    const LocalJet j = local_jet(X);
    Eigen::Vector4d r;
    for (std::size_t t = 0; t < kTriples; ++t) {
        r[static_cast<int>(t)] = std::sqrt(kMultiplicity[t] * j.frame.area) * j.T[t];
    }
    return r;
}

CurvatureVariation linearised_curvature_variation(const Derivatives& X) {
    const LocalJet j = local_jet(X);
    CurvatureVariation result;
    for (std::size_t t = 0; t < kTriples; ++t) {
        const double scale = std::sqrt(kMultiplicity[t] * j.frame.area);
        const auto column = static_cast<int>(t);
        result.residual[column] = scale * j.T[t];
        const LocalGradient g = gradient_of(j, t);
        Nine n, e1, e2;
        from_local(j.frame, g.n, n);
        from_local(j.frame, g.e[0], e1);
        from_local(j.frame, g.e[1], e2);
        for (std::size_t d = 0; d < 9; ++d) {
            result.jacobian.block<3, 1>(3 * static_cast<int>(d), column) =
                scale * (n[d] * j.frame.n + e1[d] * j.frame.e1 + e2[d] * j.frame.e2);
        }
    }
    return result;
}

}  // namespace suture::mvs

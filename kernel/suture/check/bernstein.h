#pragma once

#include <Eigen/Geometry>

#include <algorithm>
#include <vector>

namespace suture::bernstein {

/// A polynomial in two variables over the unit square in Bernstein's form, with v fastest.
template <class Value>
struct Bernstein {
    int m = 0, n = 0;
    std::vector<Value> c;

    Bernstein(int m_, int n_, const Value& zero)
        : m(m_), n(n_), c(static_cast<std::size_t>((m_ + 1) * (n_ + 1)), zero) {}
    [[nodiscard]] Value& at(int i, int j) { return c[static_cast<std::size_t>(i * (n + 1) + j)]; }
    [[nodiscard]] const Value& at(int i, int j) const {
        return c[static_cast<std::size_t>(i * (n + 1) + j)];
    }
};
using Scalars = Bernstein<double>;
using Vectors = Bernstein<Eigen::Vector3d>;

inline const Eigen::Vector3d kNull = Eigen::Vector3d::Zero();

inline double binomial(int n, int k) {
    double result = 1.0;
    for (int i = 1; i <= k; ++i) {
        result *= static_cast<double>(n - k + i) / i;
    }
    return result;
}

inline std::vector<double> binomials(int n) {
    std::vector<double> row;
    for (int k = 0; k <= n; ++k) {
        row.push_back(binomial(n, k));
    }
    return row;
}

/// The coefficients times their binomials: products of such forms are plain convolutions.
template <class Value>
Bernstein<Value> scaled(Bernstein<Value> a, bool inverse) {
    const auto u = binomials(a.m);
    const auto v = binomials(a.n);
    for (int i = 0; i <= a.m; ++i) {
        for (int j = 0; j <= a.n; ++j) {
            const double factor = u[static_cast<std::size_t>(i)] * v[static_cast<std::size_t>(j)];
            a.at(i, j) *= inverse ? 1.0 / factor : factor;
        }
    }
    return a;
}

template <class A, class B, class Out, class Product>
Bernstein<Out> multiplied(const Bernstein<A>& a, const Bernstein<B>& b, const Out& zero,
                          Product&& product) {
    const auto x = scaled(a, false);
    const auto y = scaled(b, false);
    Bernstein<Out> result(a.m + b.m, a.n + b.n, zero);
    for (int i = 0; i <= a.m; ++i) {
        for (int j = 0; j <= a.n; ++j) {
            for (int k = 0; k <= b.m; ++k) {
                for (int l = 0; l <= b.n; ++l) {
                    result.at(i + k, j + l) += product(x.at(i, j), y.at(k, l));
                }
            }
        }
    }
    return scaled(result, true);
}

inline Vectors cross(const Vectors& a, const Vectors& b) {
    return multiplied(a, b, kNull, [](const Eigen::Vector3d& x, const Eigen::Vector3d& y) {
        return Eigen::Vector3d(x.cross(y));
    });
}

inline Vectors times(const Scalars& a, const Vectors& b) {
    return multiplied(a, b, kNull,
                      [](double x, const Eigen::Vector3d& y) { return Eigen::Vector3d(x * y); });
}

/// But for the factor degree over width, which is positive.
template <class Value>
Bernstein<Value> derivative(const Bernstein<Value>& a, bool by_u, const Value& zero) {
    Bernstein<Value> result(by_u ? a.m - 1 : a.m, by_u ? a.n : a.n - 1, zero);
    for (int i = 0; i <= result.m; ++i) {
        for (int j = 0; j <= result.n; ++j) {
            result.at(i, j) =
                (by_u ? a.m : a.n) * (a.at(by_u ? i + 1 : i, by_u ? j : j + 1) - a.at(i, j));
        }
    }
    return result;
}

inline Vectors difference(Vectors a, const Vectors& b) {
    std::ranges::transform(a.c, b.c, a.c.begin(),
                           [](const auto& x, const auto& y) { return Eigen::Vector3d(x - y); });
    return a;
}

}  // namespace suture::bernstein

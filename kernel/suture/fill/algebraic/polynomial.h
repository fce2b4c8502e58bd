#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace suture::algebraic {

/// x^i y^j z^k
struct Monomial {
    int i = 0, j = 0, k = 0;
    [[nodiscard]] int degree() const { return i + j + k; }
};

/// How many monomials in three variables have at most this degree; 0 for a negative degree.
constexpr int monomial_count(int degree) {
    return degree < 0 ? 0 : (degree + 1) * (degree + 2) * (degree + 3) / 6;
}

/// Monomials are numbered by degree first, so that those of a lower degree come first.
constexpr int index_of(const Monomial& m) {
    const int rest = m.j + m.k;
    return monomial_count(m.i + rest - 1) + rest * (rest + 1) / 2 + m.k;
}

/// monomials(d)[n] is the monomial with number n, up to degree d.
[[nodiscard]] std::vector<Monomial> monomials(int degree);

/// A polynomial in x, y, z over a field T: double, or exact rationals.
template <class T>
struct Polynomial {
    int degree = 0;                        ///< an upper bound
    std::vector<T> coefficients = {T(0)};  ///< monomial_count(degree) of them

    Polynomial() = default;
    explicit Polynomial(T constant) : coefficients{std::move(constant)} {}

    static Polynomial zero(int degree) {
        Polynomial p;
        p.degree = degree;
        p.coefficients.assign(static_cast<std::size_t>(monomial_count(degree)), T(0));
        return p;
    }
    /// a x + b y + c z + d
    static Polynomial linear(const std::array<T, 3>& normal, const T& constant) {
        Polynomial p;
        p.degree = 1;
        p.coefficients = {constant, normal[0], normal[1], normal[2]};
        return p;
    }
    static Polynomial variable(int axis) {
        std::array<T, 3> normal{T(0), T(0), T(0)};
        normal[static_cast<std::size_t>(axis)] = T(1);
        return linear(normal, T(0));
    }

    [[nodiscard]] const T& operator[](const Monomial& m) const {
        return coefficients[static_cast<std::size_t>(index_of(m))];
    }
    [[nodiscard]] T& operator[](const Monomial& m) {
        return coefficients[static_cast<std::size_t>(index_of(m))];
    }
};

template <class T>
Polynomial<T>& operator+=(Polynomial<T>& a, const Polynomial<T>& b) {
    if (a.degree < b.degree) {
        a.degree = b.degree;
        a.coefficients.resize(b.coefficients.size(), T(0));
    }
    for (std::size_t n = 0; n < b.coefficients.size(); ++n) {
        a.coefficients[n] += b.coefficients[n];
    }
    return a;
}

template <class T>
Polynomial<T> operator*(const Polynomial<T>& a, const Polynomial<T>& b) {
    auto product = Polynomial<T>::zero(a.degree + b.degree);
    const std::vector<Monomial> left = monomials(a.degree);
    const std::vector<Monomial> right = monomials(b.degree);
    for (std::size_t m = 0; m < left.size(); ++m) {
        if (a.coefficients[m] == T(0)) {
            continue;
        }
        for (std::size_t n = 0; n < right.size(); ++n) {
            product[{left[m].i + right[n].i, left[m].j + right[n].j, left[m].k + right[n].k}] +=
                a.coefficients[m] * b.coefficients[n];
        }
    }
    return product;
}

template <class T>
Polynomial<T> operator*(const T& factor, Polynomial<T> p) {
    for (T& c : p.coefficients) {
        c *= factor;
    }
    return p;
}

template <class T>
Polynomial<T> operator+(Polynomial<T> a, const Polynomial<T>& b) {
    return a += b;
}

template <class T>
Polynomial<T> operator-(Polynomial<T> a, const Polynomial<T>& b) {
    return a += T(-1) * b;
}

template <class T>
Polynomial<T> power(const Polynomial<T>& p, int exponent) {
    Polynomial<T> result(T(1));
    for (int n = 0; n < exponent; ++n) {
        result = result * p;
    }
    return result;
}

/// p(x, y, z) with polynomials put in for the variables: of a point moved, turned or scaled.
template <class T>
Polynomial<T> substitute(const Polynomial<T>& p, const std::array<Polynomial<T>, 3>& variables) {
    std::array<std::vector<Polynomial<T>>, 3> powers;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        powers[axis] = {Polynomial<T>(T(1))};
        for (int n = 1; n <= p.degree; ++n) {
            powers[axis].push_back(powers[axis].back() * variables[axis]);
        }
    }
    Polynomial<T> result;
    const std::vector<Monomial> all = monomials(p.degree);
    for (std::size_t n = 0; n < all.size(); ++n) {
        if (p.coefficients[n] != T(0)) {
            const auto at = [&](std::size_t axis, int e) {
                return powers[axis][static_cast<std::size_t>(e)];
            };
            result += p.coefficients[n] * (at(0, all[n].i) * at(1, all[n].j) * at(2, all[n].k));
        }
    }
    return result;
}

/// Value at a point.
template <class T>
T evaluate(const Polynomial<T>& p, const std::array<T, 3>& x) {
    T sum(0);
    const std::vector<Monomial> all = monomials(p.degree);
    std::array<std::vector<T>, 3> powers;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        powers[axis] = {T(1)};
        for (int n = 1; n <= p.degree; ++n) {
            powers[axis].push_back(powers[axis].back() * x[axis]);
        }
    }
    for (std::size_t n = 0; n < all.size(); ++n) {
        if (p.coefficients[n] != T(0)) {
            sum += p.coefficients[n] * powers[0][static_cast<std::size_t>(all[n].i)] *
                   powers[1][static_cast<std::size_t>(all[n].j)] *
                   powers[2][static_cast<std::size_t>(all[n].k)];
        }
    }
    return sum;
}

}  // namespace suture::algebraic

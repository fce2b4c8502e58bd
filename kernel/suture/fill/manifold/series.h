#pragma once

#include <Eigen/Core>

#include <algorithm>

namespace suture::manifold {

/// A power series in (u, v), truncated at a total order: sum c_ij u^i v^j, i + j <= order. The
/// coefficients are vectors of Rows entries (1: a function, 3: a point, 4: a homogeneous point).
template <int Rows>
class Series {
  public:
    using Value = Eigen::Matrix<double, Rows, 1>;

    Series() = default;
    explicit Series(int order) : order_(order), terms_(Terms::Zero(Rows, index(0, order) + 1)) {}

    [[nodiscard]] int order() const { return order_; }
    [[nodiscard]] auto term(int i, int j) { return terms_.col(index(i, j)); }
    [[nodiscard]] auto term(int i, int j) const { return terms_.col(index(i, j)); }

    /// The partial derivative d^(i+j) / du^i dv^j at the origin.
    [[nodiscard]] Value derivative(int i, int j) const {
        double factorials = 1.0;
        for (int a = 2; a <= i; ++a) {
            factorials *= a;
        }
        for (int b = 2; b <= j; ++b) {
            factorials *= b;
        }
        return factorials * term(i, j);
    }

    Series& operator+=(const Series& other) {
        terms_ += other.terms_;
        return *this;
    }
    Series& operator-=(const Series& other) {
        terms_ -= other.terms_;
        return *this;
    }
    Series& operator*=(double factor) {
        terms_ *= factor;
        return *this;
    }
    friend Series operator+(Series a, const Series& b) { return a += b; }
    friend Series operator-(Series a, const Series& b) { return a -= b; }
    friend Series operator*(double factor, Series a) { return a *= factor; }

    /// The terms of one row.
    [[nodiscard]] Series<1> row(int k) const {
        Series<1> result(order_);
        for (int i = 0; i <= order_; ++i) {
            for (int j = 0; i + j <= order_; ++j) {
                result.term(i, j)[0] = term(i, j)[k];
            }
        }
        return result;
    }

  private:
    /// Up to the order 6 without asking for memory.
    static constexpr int kMostTerms = 28;
    using Terms = Eigen::Matrix<double, Rows, Eigen::Dynamic,
                                Rows == 1 ? Eigen::RowMajor : Eigen::ColMajor, Rows, kMostTerms>;

    int order_ = 0;
    Terms terms_ = Terms::Zero(Rows, 1);

    /// Terms by their total order, so that a series of lower order is a beginning.
    static int index(int i, int j) { return (i + j) * (i + j + 1) / 2 + j; }
};

/// Truncated product.
template <int Rows>
Series<Rows> operator*(const Series<1>& a, const Series<Rows>& b) {
    const int order = std::min(a.order(), b.order());
    Series<Rows> result(order);
    for (int i = 0; i <= order; ++i) {
        for (int j = 0; i + j <= order; ++j) {
            const double factor = a.term(i, j)[0];
            if (factor == 0.0) {
                continue;
            }
            for (int p = 0; i + j + p <= order; ++p) {
                for (int q = 0; i + j + p + q <= order; ++q) {
                    result.term(i + p, j + q) += factor * b.term(p, q);
                }
            }
        }
    }
    return result;
}

/// The constant c as a series.
inline Series<1> constant(double c, int order) {
    Series<1> result(order);
    result.term(0, 0)[0] = c;
    return result;
}

/// u = at + du, or v = at + dv, as a series.
inline Series<1> variable(double at, int which, int order) {
    Series<1> result = constant(at, order);
    if (order > 0) {
        result.term(which == 0 ? 1 : 0, which == 0 ? 0 : 1)[0] = 1.0;
    }
    return result;
}

/// The polynomial sum_l c_l x^l of a series x.
inline Series<1> polynomial(const Eigen::VectorXd& c, const Series<1>& x) {
    Series<1> result(x.order());
    for (Eigen::Index l = c.size() - 1; l >= 0; --l) {
        result = result * x;
        result.term(0, 0)[0] += c[l];
    }
    return result;
}

/// x without its constant term.
inline Series<1> increment(Series<1> x) {
    x.term(0, 0)[0] = 0.0;
    return x;
}

/// outer(x, y), for series x and y without constant terms: Horner's rule in both.
template <int Rows>
Series<Rows> compose(const Series<Rows>& outer, const Series<1>& x, const Series<1>& y) {
    const int order = x.order();
    Series<Rows> by_x(order);
    for (int a = order; a >= 0; --a) {
        Series<Rows> by_y(order);
        for (int b = order - a; b >= 0; --b) {
            by_y = y * by_y;
            by_y.term(0, 0) += outer.term(a, b);
        }
        by_x = x * by_x;
        by_x += by_y;
    }
    return by_x;
}

/// A homogeneous point (w p, w) as the point p.
inline Series<3> project(const Series<4>& h) {
    const int order = h.order();
    Series<3> result(order);
    for (int sum = 0; sum <= order; ++sum) {
        for (int j = 0; j <= sum; ++j) {
            const int i = sum - j;
            Eigen::Vector3d value = h.term(i, j).template head<3>();
            for (int p = 0; p <= i; ++p) {
                for (int q = 0; q <= j; ++q) {
                    if (p + q > 0) {
                        value -= h.term(p, q)[3] * result.term(i - p, j - q);
                    }
                }
            }
            result.term(i, j) = value / h.term(0, 0)[3];
        }
    }
    return result;
}

}  // namespace suture::manifold

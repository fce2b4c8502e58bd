#include "suture/check/certify/bezier_piece.h"

namespace suture::certify {

namespace {

// More than the roundings that one number of a blossom or a change of basis has gone through,
// for each degree.
constexpr double kRoundingsPerDegree = 8.0;

/// A number and the sum of the absolute values that it was made of, which bounds its rounding
/// error.
struct Number {
    double value = 0.0, size = 0.0;
};

Number combined(double factor_a, const Number& a, double factor_b, const Number& b) {
    return {factor_a * a.value + factor_b * b.value,
            std::abs(factor_a) * a.size + std::abs(factor_b) * b.size};
}

/// The value of the polar form of span k at `lows` times the low and else the high end.
Number blossom(std::vector<Number> d, const std::vector<double>& knots, int k, int degree,
               const Span& ends, int highs) {
    for (int r = 1; r <= degree; ++r) {
        const double argument = r <= highs ? ends.high : ends.low;
        for (int j = degree; j >= r; --j) {
            const auto left = static_cast<std::size_t>(k - degree + j);
            const double from = knots[left];
            const double to = knots[left + static_cast<std::size_t>(degree - r + 1)];
            const double s = (argument - from) / (to - from);
            const auto index = static_cast<std::size_t>(j);
            d[index] = combined(1.0 - s, d[index - 1], s, d[index]);
        }
    }
    return d.back();
}

/// Bezier points over the ends, from the poles of span k.
std::vector<Number> bezier(const std::vector<Number>& poles, const std::vector<double>& knots,
                           int k, int degree, const Span& ends) {
    std::vector<Number> result;
    for (int highs = 0; highs <= degree; ++highs) {
        result.push_back(blossom(poles, knots, k, degree, ends, highs));
    }
    return result;
}

/// Coefficients of powers of x in [-1, 1], from Bezier points: de Casteljau's division in the
/// middle gives those of [0, 1], whose differences are the derivatives there.
std::vector<Number> powers_of(std::vector<Number> b) {
    const std::size_t degree = b.size() - 1;
    for (std::size_t r = 1; r <= degree; ++r) {
        for (std::size_t j = 0; j + r <= degree; ++j) {
            b[j] = combined(0.5, b[j], 0.5, b[j + 1]);
        }
    }
    double binomial = 1.0;
    std::vector<Number> powers;
    for (std::size_t i = 0; i <= degree; ++i) {
        powers.push_back({binomial * b.front().value, binomial * b.front().size});
        for (std::size_t j = 0; j + 1 < b.size(); ++j) {
            b[j] = combined(1.0, b[j + 1], -1.0, b[j]);
        }
        b.pop_back();
        binomial *= static_cast<double>(degree - i) / static_cast<double>(i + 1);
    }
    return powers;
}

/// A coordinate of a homogeneous pole, counted from the origin.
Number counted_from(const std::array<double, 3>& origin, const std::array<double, 4>& pole,
                    std::size_t c) {
    const double shift = c < 3 ? pole[3] * origin.at(c) : 0.0;
    return {pole.at(c) - shift, std::abs(pole.at(c)) + std::abs(shift)};
}

double error_of(const Number& number, int degrees) {
    return kRoundingsPerDegree * (degrees + 1) * kRounding * number.size;
}

/// The largest rounding error of Bezier points. It reaches the function undiminished, but not more:
/// that is a mean of them. From here on their own size counts, which is small.
double settle(std::vector<Number>& points, int degrees) {
    double error = 0.0;
    for (Number& point : points) {
        error = std::max(error, error_of(point, degrees));
        point.size = std::abs(point.value);
    }
    return error;
}

}  // namespace

TaylorModel3 curve_model(const SplineCurve& curve, int k, const Span& stretch,
                         const std::array<double, 3>& origin) {
    std::array<TaylorModel, 4> models;
    for (std::size_t c = 0; c < (curve.rational ? 4U : 3U); ++c) {
        std::vector<Number> poles;
        for (int i = k - curve.degree; i <= k; ++i) {
            poles.push_back(counted_from(origin, curve.poles[static_cast<std::size_t>(i)], c));
        }
        std::vector<Number> points = bezier(poles, curve.knots, k, curve.degree, stretch);
        double error = settle(points, curve.degree);
        std::vector<double> values;
        for (const Number& power : powers_of(points)) {
            values.push_back(power.value);
            error += error_of(power, curve.degree);
        }
        models.at(c) = TaylorModel(values, error);
    }
    const TaylorModel3 point = {models[0], models[1], models[2]};
    return curve.rational ? inverse(models[3]) * point : point;
}

BezierPiece::BezierPiece(const SplineSurface& surface, int ku, int kv, const Span& u, const Span& v,
                         const std::array<double, 3>& origin)
    : p_(surface.degree_u), q_(surface.degree_v), rational_(surface.rational) {
    const auto rows = static_cast<std::size_t>(p_ + 1);
    const auto columns = static_cast<std::size_t>(q_ + 1);
    const auto column_of = [&](const std::vector<Number>& net, std::size_t j) {
        std::vector<Number> column;
        for (std::size_t i = 0; i < rows; ++i) {
            column.push_back(net[i * columns + j]);
        }
        return column;
    };
    // Along every row of a net, then along every column.
    const auto both_ways = [&](std::vector<Number> net, const auto& along_v, const auto& along_u) {
        for (std::size_t i = 0; i < rows; ++i) {
            const auto start = net.begin() + static_cast<std::ptrdiff_t>(i * columns);
            const std::vector<Number> row =
                along_v(std::vector<Number>(start, start + static_cast<std::ptrdiff_t>(columns)));
            std::ranges::copy(row, start);
        }
        for (std::size_t j = 0; j < columns; ++j) {
            const std::vector<Number> column = along_u(column_of(net, j));
            for (std::size_t i = 0; i < rows; ++i) {
                net[i * columns + j] = column[i];
            }
        }
        return net;
    };
    for (std::size_t c = 0; c < (rational_ ? 4U : 3U); ++c) {
        std::vector<Number> net;
        for (int i = ku - p_; i <= ku; ++i) {
            for (int j = kv - q_; j <= kv; ++j) {
                const auto index = static_cast<std::size_t>(i * surface.poles_v() + j);
                net.push_back(counted_from(origin, surface.poles[index], c));
            }
        }
        std::vector<Number> points = both_ways(
            std::move(net),
            [&](const std::vector<Number>& row) { return bezier(row, surface.knots_v, kv, q_, v); },
            [&](const std::vector<Number>& column) {
                return bezier(column, surface.knots_u, ku, p_, u);
            });
        net_error_.at(c) = settle(points, p_ + q_);
        for (const Number& power : both_ways(std::move(points), powers_of, powers_of)) {
            powers_.at(c).push_back(power.value);
            errors_.at(c).push_back(error_of(power, p_ + q_));
        }
    }
}

namespace {

/// n (n-1) ... of `order` factors: of the derivative of x^n.
double falling(int n, int order) {
    double product = 1.0;
    for (int k = 0; k < order; ++k) {
        product *= n - k;
    }
    return product;
}

}  // namespace

std::array<TaylorModel, 4> BezierPiece::derivative(int di, int dj, const TaylorModel& x,
                                                   const TaylorModel& y) const {
    std::array<TaylorModel, 4> result;
    result[3] = di + dj == 0 ? 1.0 : 0.0;
    for (std::size_t c = 0; c < (rational_ ? 4U : 3U); ++c) {
        double error = falling(p_, di) * falling(q_, dj) * net_error_.at(c);
        TaylorModel sum;
        for (int i = p_; i >= di; --i) {
            TaylorModel row;
            for (int j = q_; j >= dj; --j) {
                const auto index = static_cast<std::size_t>(i * (q_ + 1) + j);
                const double factor = falling(i, di) * falling(j, dj);
                row = row * y + TaylorModel(factor * powers_.at(c)[index]);
                error +=
                    factor * (errors_.at(c)[index] + kRounding * std::abs(powers_.at(c)[index]));
            }
            sum = sum * x + row;
        }
        result.at(c) = sum.widened(error);
    }
    return result;
}

std::array<Interval, 4> BezierPiece::bound(int di, int dj) const {
    std::array<Interval, 4> result;
    result[3] = di + dj == 0 ? Interval{1.0, 1.0} : Interval{};
    for (std::size_t c = 0; c < (rational_ ? 4U : 3U); ++c) {
        // |x|, |y| <= 1: the constant, and everything else at its largest.
        double middle = 0.0;
        double around = falling(p_, di) * falling(q_, dj) * net_error_.at(c);
        for (int i = di; i <= p_; ++i) {
            for (int j = dj; j <= q_; ++j) {
                const auto index = static_cast<std::size_t>(i * (q_ + 1) + j);
                const double factor = falling(i, di) * falling(j, dj);
                const double term = factor * powers_.at(c)[index];
                if (i == di && j == dj) {
                    middle = term;
                } else {
                    around += std::abs(term);
                }
                around += factor * errors_.at(c)[index] + 4 * kRounding * std::abs(term);
            }
        }
        result.at(c) = Interval{middle - around, middle + around}.widened();
    }
    return result;
}

BezierPiece::Jet BezierPiece::along(const TaylorModel& x, const TaylorModel& y) const {
    const auto a = derivative(0, 0, x, y);
    const auto ax = derivative(1, 0, x, y);
    const auto ay = derivative(0, 1, x, y);
    Jet jet{{a[0], a[1], a[2]}, {ax[0], ax[1], ax[2]}, {ay[0], ay[1], ay[2]}};
    if (rational_) {
        // S = A / w, so that S_x = (A_x - w_x S) / w.
        const TaylorModel over = inverse(a[3]);
        jet.S = over * jet.S;
        jet.Sx = over * (jet.Sx - ax[3] * jet.S);
        jet.Sy = over * (jet.Sy - ay[3] * jet.S);
    }
    return jet;
}

BezierPiece::Jet BezierPiece::divided(const TaylorModel& x, const TaylorModel& y) const {
    const auto columns = static_cast<std::size_t>(q_ + 1);
    const auto rows = static_cast<std::size_t>(p_ + 1);
    const auto start = [&](std::size_t c) {
        double value = 0.0;
        for (std::size_t i = 0; i < rows; ++i) {
            value += (i % 2 == 0 ? 1.0 : -1.0) * powers_.at(c)[i * columns];
        }
        return value;
    };
    const double w0 = rational_ ? start(3) : 1.0;
    BezierPiece quotient = *this;
    quotient.p_ = p_ - 1;
    quotient.rational_ = false;
    for (std::size_t c = 0; c < 3; ++c) {
        const double P = start(c) / w0;
        std::vector<double>& b = quotient.powers_.at(c);
        std::vector<double>& errors = quotient.errors_.at(c);
        b.assign((rows - 1) * columns, 0.0);
        errors.assign(b.size(), 0.0);
        for (std::size_t j = 0; j < columns; ++j) {
            // Divided from the highest power down; what remains is 0 but for rounding.
            double above = 0.0;
            double error = 0.0;
            for (std::size_t i = rows - 1; i >= 1; --i) {
                const std::size_t from = i * columns + j;
                double value = powers_.at(c)[from];
                error += errors_.at(c)[from] + kRounding * std::abs(value);
                if (rational_) {
                    value -= powers_[3][from] * P;
                    error += std::abs(P) *
                             (errors_[3][from] + 4 * kRounding * std::abs(powers_[3][from]));
                }
                above = value - above;
                error += kRounding * std::abs(above);
                b[from - columns] = above;
                errors[from - columns] = error;
            }
        }
        // As Bezier points: p/i of a difference of two of them, by half of x + 1.
        quotient.net_error_.at(c) =
            p_ * (net_error_.at(c) + (rational_ ? std::abs(P) * net_error_[3] : 0.0));
    }
    const auto t = quotient.derivative(0, 0, x, y);
    const auto tx = quotient.derivative(1, 0, x, y);
    const auto ty = quotient.derivative(0, 1, x, y);
    Jet jet{{t[0], t[1], t[2]}, {tx[0], tx[1], tx[2]}, {ty[0], ty[1], ty[2]}};
    if (rational_) {
        const TaylorModel over = inverse(derivative(0, 0, x, y)[3]);
        jet.S = over * jet.S;
        jet.Sx = over * (jet.Sx - derivative(1, 0, x, y)[3] * jet.S);
        jet.Sy = over * (jet.Sy - derivative(0, 1, x, y)[3] * jet.S);
    }
    return jet;
}

BezierPiece::Bounds BezierPiece::bounds() const {
    const auto a = bound(0, 0);
    const auto ax = bound(1, 0);
    const auto ay = bound(0, 1);
    const auto axx = bound(2, 0);
    const auto axy = bound(1, 1);
    const auto ayy = bound(0, 2);
    Bounds b;
    const bool divisible = a[3].low > 0.0 || a[3].high < 0.0;
    constexpr double kInfinite = std::numeric_limits<double>::infinity();
    for (std::size_t c = 0; c < 3; ++c) {
        if (!rational_) {
            b.S.at(c) = a.at(c);
            b.Sx.at(c) = ax.at(c);
            b.Sy.at(c) = ay.at(c);
            b.Sxx.at(c) = axx.at(c);
            b.Sxy.at(c) = axy.at(c);
            b.Syy.at(c) = ayy.at(c);
        } else if (!divisible) {
            b.S.at(c) = {-kInfinite, kInfinite};
        } else {
            const Interval two{2.0, 2.0};
            b.S.at(c) = a.at(c) / a[3];
            b.Sx.at(c) = (ax.at(c) - ax[3] * b.S.at(c)) / a[3];
            b.Sy.at(c) = (ay.at(c) - ay[3] * b.S.at(c)) / a[3];
            b.Sxx.at(c) = (axx.at(c) - two * ax[3] * b.Sx.at(c) - axx[3] * b.S.at(c)) / a[3];
            b.Sxy.at(c) =
                (axy.at(c) - ax[3] * b.Sy.at(c) - ay[3] * b.Sx.at(c) - axy[3] * b.S.at(c)) / a[3];
            b.Syy.at(c) = (ayy.at(c) - two * ay[3] * b.Sy.at(c) - ayy[3] * b.S.at(c)) / a[3];
        }
    }
    return b;
}

}  // namespace suture::certify

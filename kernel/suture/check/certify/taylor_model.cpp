#include "suture/check/certify/taylor_model.h"

#include <numeric>

namespace suture::certify {

namespace {

constexpr int kCount = TaylorModel::kDegree + 1;
constexpr double kInfinite = std::numeric_limits<double>::infinity();
// Radii are sums of positive numbers: this factor is more than all their rounding errors together.
constexpr double kSafe = 1.0 + 1e-12;
// Series of 1/(1+d) and sqrt(1+d) are used up to this |d|.
constexpr double kSeries = 0.5;

/// Bernstein coefficients of degree kDegree of x^power on [-1, 1]; none is larger than 1.
std::array<std::array<double, kCount>, kCount> make_bernstein_of_powers() {
    // Multiplied by x: b_k of degree n becomes (k b_(k-1) - (n+1-k) b_k) / (n+1); by 1: + instead.
    std::array<std::array<double, kCount>, kCount> table = {};
    for (int power = 0; power < kCount; ++power) {
        std::array<double, kCount> b = {1.0};
        for (int n = 0; n < TaylorModel::kDegree; ++n) {
            const double sign = n < power ? -1.0 : 1.0;
            std::array<double, kCount> next = {};
            for (int k = 0; k <= n + 1; ++k) {
                const double before = k > 0 ? b.at(static_cast<std::size_t>(k - 1)) : 0.0;
                const double same = k <= n ? b.at(static_cast<std::size_t>(k)) : 0.0;
                next.at(static_cast<std::size_t>(k)) =
                    (k * before + sign * (n + 1 - k) * same) / (n + 1);
            }
            b = next;
        }
        table.at(static_cast<std::size_t>(power)) = b;
    }
    return table;
}

/// sum of series[k] d^k, with the tail's bound.
TaylorModel series(const TaylorModel& d, const std::array<double, kCount>& factors, double tail) {
    TaylorModel sum = factors.back();
    for (int k = kCount - 2; k >= 0; --k) {
        sum = sum * d + TaylorModel(factors.at(static_cast<std::size_t>(k)));
    }
    return sum.widened(tail);
}

}  // namespace

TaylorModel::TaylorModel(const std::vector<double>& powers, double radius) : radius_(radius) {
    for (std::size_t i = 0; i < powers.size(); ++i) {
        if (i < coefficients_.size()) {
            coefficients_.at(i) = powers[i];
        } else {
            radius_ += kSafe * std::abs(powers[i]);
        }
    }
}

TaylorModel TaylorModel::linear(double center, double half_width) {
    TaylorModel model(center);
    model.coefficients_[1] = half_width;
    return model;
}

TaylorModel TaylorModel::nothing_known() {
    return TaylorModel().widened(kInfinite);
}

double TaylorModel::size() const {
    return std::accumulate(coefficients_.begin(), coefficients_.end(), 0.0,
                           [](double sum, double c) { return sum + std::abs(c); });
}

Interval TaylorModel::range() const {
    static const auto table = make_bernstein_of_powers();
    if (!known()) {
        return {-kInfinite, kInfinite};
    }
    Interval result{kInfinite, -kInfinite};
    for (std::size_t k = 0; k < coefficients_.size(); ++k) {
        double value = 0.0;
        for (std::size_t i = 0; i < coefficients_.size(); ++i) {
            value += coefficients_.at(i) * table.at(i).at(k);
        }
        result.low = std::min(result.low, value);
        result.high = std::max(result.high, value);
    }
    const double by = radius_ + 2 * kCount * kRounding * size();
    return Interval{result.low - by, result.high + by}.widened();
}

TaylorModel TaylorModel::widened(double by) const {
    TaylorModel result = *this;
    result.radius_ = kSafe * (radius_ + by);
    return result;
}

TaylorModel& TaylorModel::operator+=(const TaylorModel& other) {
    for (std::size_t i = 0; i < coefficients_.size(); ++i) {
        coefficients_.at(i) += other.coefficients_.at(i);
    }
    radius_ = kSafe * (radius_ + other.radius_ + kRounding * size());
    return *this;
}

TaylorModel operator-(const TaylorModel& a, const TaylorModel& b) {
    TaylorModel minus = b;
    for (double& c : minus.coefficients_) {
        c = -c;
    }
    return minus += a;
}

TaylorModel operator*(const TaylorModel& a, const TaylorModel& b) {
    if (!a.known() || !b.known()) {
        return TaylorModel::nothing_known();
    }
    TaylorModel product;
    double cut_off = 0.0;
    for (int i = 0; i < kCount; ++i) {
        const double factor = a.coefficients_.at(static_cast<std::size_t>(i));
        for (int j = 0; j < kCount && factor != 0.0; ++j) {
            const double term = factor * b.coefficients_.at(static_cast<std::size_t>(j));
            if (i + j < kCount) {
                product.coefficients_.at(static_cast<std::size_t>(i + j)) += term;
            } else {
                cut_off += std::abs(term);
            }
        }
    }
    const double size_a = a.size();
    const double size_b = b.size();
    product.radius_ = kSafe * (cut_off + size_a * b.radius_ + size_b * a.radius_ +
                               a.radius_ * b.radius_ + 2 * kCount * kRounding * size_a * size_b);
    return product;
}

TaylorModel inverse(const TaylorModel& a) {
    const double middle = a.middle();
    const TaylorModel d = a * TaylorModel(1.0 / middle) - TaylorModel(1.0);
    const double most = d.range().magnitude();
    if (!(most <= kSeries)) {
        return TaylorModel::nothing_known();
    }
    std::array<double, kCount> factors = {};
    for (std::size_t k = 0; k < factors.size(); ++k) {
        factors.at(k) = k % 2 == 0 ? 1.0 : -1.0;
    }
    const double tail = std::pow(most, kCount) / (1.0 - most);
    // The rounding of 1/middle counts twice: in d, and in the result's factor.
    const TaylorModel result = series(d.widened(2 * kRounding), factors, kSafe * tail);
    return TaylorModel(1.0 / middle).widened(kRounding / std::abs(middle)) * result;
}

TaylorModel sqrt(const TaylorModel& a) {
    const double middle = a.middle();
    if (!(middle > 0.0)) {
        return TaylorModel::nothing_known();
    }
    const TaylorModel d = (a * TaylorModel(1.0 / middle) - TaylorModel(1.0)).widened(2 * kRounding);
    const double most = d.range().magnitude();
    if (!(most <= kSeries)) {
        return TaylorModel::nothing_known();
    }
    std::array<double, kCount> factors = {1.0};
    for (std::size_t k = 1; k < factors.size(); ++k) {
        factors.at(k) =
            factors.at(k - 1) * (0.5 - (static_cast<double>(k) - 1.0)) / static_cast<double>(k);
    }
    // Later factors are smaller; the rounding of the factors counts with the series.
    const double tail =
        std::abs(factors.back()) * std::pow(most, kCount) / (1.0 - most) + 16 * kRounding;
    const double root = std::sqrt(middle);
    return TaylorModel(root).widened(kRounding * root) * series(d, factors, kSafe * tail);
}

namespace {

/// cos(center + phase + half_width x); derivatives are cosines a quarter turn on.
TaylorModel turning(double cosine_of_center, double sine_of_center, double half_width) {
    const std::array<double, 4> derivatives = {cosine_of_center, -sine_of_center, -cosine_of_center,
                                               sine_of_center};
    std::vector<double> powers;
    double factor = 1.0;
    for (int i = 0; i < kCount; ++i) {
        powers.push_back(derivatives.at(static_cast<std::size_t>(i % 4)) * factor);
        factor *= half_width / (i + 1);
    }
    const double rounding = 2 * kCount * kRounding * std::exp(std::abs(half_width));
    return {powers, kSafe * (std::abs(factor) + rounding)};
}

}  // namespace

TaylorModel cosine(double center, double half_width) {
    return turning(std::cos(center), std::sin(center), half_width);
}

TaylorModel sine(double center, double half_width) {
    return turning(std::sin(center), -std::cos(center), half_width);
}

TaylorModel exponential(double center, double half_width) {
    const double middle = std::exp(center);
    std::vector<double> powers;
    double term = middle;
    for (int i = 0; i < kCount; ++i) {
        powers.push_back(term);
        term *= half_width / (i + 1);
    }
    const double grown = std::exp(std::abs(half_width));
    const double rounding = 2 * kCount * kRounding * middle * grown;
    return {powers, kSafe * (std::abs(term) * grown + rounding)};
}

TaylorModel dot(const TaylorModel3& a, const TaylorModel3& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

TaylorModel3 cross(const TaylorModel3& a, const TaylorModel3& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

TaylorModel3 operator+(const TaylorModel3& a, const TaylorModel3& b) {
    return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}

TaylorModel3 operator-(const TaylorModel3& a, const TaylorModel3& b) {
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

TaylorModel3 operator*(const TaylorModel& factor, const TaylorModel3& a) {
    return {factor * a[0], factor * a[1], factor * a[2]};
}

TaylorModel3 widened(const TaylorModel3& a, double by) {
    return {a[0].widened(by), a[1].widened(by), a[2].widened(by)};
}

bool known(const TaylorModel3& a) {
    return a[0].known() && a[1].known() && a[2].known();
}

double longest(const TaylorModel3& a) {
    if (!known(a)) {
        return kInfinite;
    }
    return std::sqrt(std::max(0.0, dot(a, a).upper())) * (1.0 + kRounding);
}

}  // namespace suture::certify

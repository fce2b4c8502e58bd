#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace suture::certify {

/// Twice the rounding error of one operation, relative.
inline constexpr double kRounding = std::numeric_limits<double>::epsilon();

/// All numbers from low to high. Every result is widened by more than its rounding error, so that
/// it encloses the exact one.
struct Interval {
    double low = 0.0, high = 0.0;

    [[nodiscard]] double magnitude() const { return std::max(std::abs(low), std::abs(high)); }
    [[nodiscard]] Interval widened() const {
        const double by = kRounding * magnitude() + std::numeric_limits<double>::min();
        return {low - by, high + by};
    }
};

inline Interval operator+(const Interval& a, const Interval& b) {
    return Interval{a.low + b.low, a.high + b.high}.widened();
}
inline Interval operator-(const Interval& a, const Interval& b) {
    return Interval{a.low - b.high, a.high - b.low}.widened();
}
inline Interval operator*(const Interval& a, const Interval& b) {
    const auto [low, high] =
        std::minmax({a.low * b.low, a.low * b.high, a.high * b.low, a.high * b.high});
    return Interval{low, high}.widened();
}
/// b must not contain zero.
inline Interval operator/(const Interval& a, const Interval& b) {
    return a * Interval{1.0 / b.high, 1.0 / b.low}.widened();
}

using Interval3 = std::array<Interval, 3>;

inline Interval dot(const Interval3& a, const Interval3& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
/// No vector of the box is longer.
inline double longest(const Interval3& a) {
    return std::hypot(a[0].magnitude(), a[1].magnitude(), a[2].magnitude()) * (1.0 + 4 * kRounding);
}

}  // namespace suture::certify

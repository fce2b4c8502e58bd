#pragma once

#include "suture/check/certify/interval.h"

#include <array>
#include <vector>

namespace suture::certify {

/// A function of x in [-1, 1], known to stay within `radius` of a polynomial.
///
/// Sums and products of models enclose those of the functions: what is cut off above kDegree, and
/// what may have been lost by rounding, goes into the radius. A radius that is not finite says that
/// nothing is known.
///
/// Source   Makino and Berz, Taylor models and other validated functional inclusion methods, 2003.
class TaylorModel {
  public:
    static constexpr int kDegree = 9;

    TaylorModel() = default;
    TaylorModel(double constant) { coefficients_[0] = constant; }  // NOLINT: a number is a model

    /// Input  powers: coefficients of 1, x, x^2, ...; radius of what they leave out.
    TaylorModel(const std::vector<double>& powers, double radius);

    /// center + half_width x
    [[nodiscard]] static TaylorModel linear(double center, double half_width);
    [[nodiscard]] static TaylorModel nothing_known();

    /// Bounds by the coefficients of the polynomial in Bernstein's form.
    [[nodiscard]] Interval range() const;
    [[nodiscard]] double upper() const { return range().high; }
    [[nodiscard]] double lower() const { return range().low; }
    [[nodiscard]] double middle() const { return coefficients_[0]; }
    [[nodiscard]] bool known() const { return std::isfinite(radius_); }
    [[nodiscard]] TaylorModel widened(double by) const;

    TaylorModel& operator+=(const TaylorModel& other);
    friend TaylorModel operator+(TaylorModel a, const TaylorModel& b) { return a += b; }
    friend TaylorModel operator-(const TaylorModel& a, const TaylorModel& b);
    friend TaylorModel operator*(const TaylorModel& a, const TaylorModel& b);

    /// Nothing is known where the function may vanish, or varies by more than half of its value in
    /// the middle.
    friend TaylorModel inverse(const TaylorModel& a);
    friend TaylorModel sqrt(const TaylorModel& a);

  private:
    using Coefficients = std::array<double, kDegree + 1>;
    [[nodiscard]] double size() const;

    Coefficients coefficients_ = {};
    double radius_ = 0.0;
};

TaylorModel operator-(const TaylorModel& a, const TaylorModel& b);
TaylorModel operator*(const TaylorModel& a, const TaylorModel& b);
TaylorModel inverse(const TaylorModel& a);
TaylorModel sqrt(const TaylorModel& a);

/// Of an angle that runs linearly: center + half_width x.
[[nodiscard]] TaylorModel cosine(double center, double half_width);
[[nodiscard]] TaylorModel sine(double center, double half_width);
/// Of an exponent that runs so.
[[nodiscard]] TaylorModel exponential(double center, double half_width);

using TaylorModel3 = std::array<TaylorModel, 3>;

[[nodiscard]] TaylorModel dot(const TaylorModel3& a, const TaylorModel3& b);
[[nodiscard]] TaylorModel3 cross(const TaylorModel3& a, const TaylorModel3& b);
[[nodiscard]] TaylorModel3 operator+(const TaylorModel3& a, const TaylorModel3& b);
[[nodiscard]] TaylorModel3 operator-(const TaylorModel3& a, const TaylorModel3& b);
[[nodiscard]] TaylorModel3 operator*(const TaylorModel& factor, const TaylorModel3& a);
[[nodiscard]] TaylorModel3 widened(const TaylorModel3& a, double by);
[[nodiscard]] bool known(const TaylorModel3& a);
/// The vector is nowhere longer.
[[nodiscard]] double longest(const TaylorModel3& a);

}  // namespace suture::certify

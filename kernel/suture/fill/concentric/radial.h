#pragma once

#include <Eigen/Core>

#include <vector>

namespace suture::concentric {

/// The quintic C4 splines over given breaks of [0, 1], each by value and slope at both ends and by
/// values between: what lies along a spoke.
class Radial {
  public:
    static constexpr int kDegree = 5;

    /// Input    breaks: increasing, from 0 to 1.
    explicit Radial(std::vector<double> breaks);

    [[nodiscard]] const std::vector<double>& breaks() const { return breaks_; }
    [[nodiscard]] const std::vector<double>& knots() const { return knots_; }
    /// How many data, and poles, a spline has.
    [[nodiscard]] int count() const { return static_cast<int>(to_poles_.rows()); }
    /// Where its values between the ends are given.
    [[nodiscard]] const std::vector<double>& sites() const { return sites_; }

    /// Input    data: dimension x count(): value and slope at 0, values at the sites, slope and
    ///          value at 1.
    /// Result   poles, dimension x count(); the first and the last are the values at the ends.
    [[nodiscard]] Eigen::MatrixXd poles(const Eigen::MatrixXd& data) const;

    /// A spline by its poles: value and slope, dimension x 2.
    [[nodiscard]] Eigen::MatrixXd evaluate(const Eigen::MatrixXd& poles, double t) const;

  private:
    std::vector<double> breaks_;
    std::vector<double> knots_;
    std::vector<double> sites_;
    Eigen::MatrixXd to_poles_;
};

}  // namespace suture::concentric

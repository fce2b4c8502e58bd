#pragma once

#include "suture/spline/curve.h"

#include <Eigen/Core>

#include <vector>

namespace suture::concentric {

/// The cubic splines over evenly spread knots on [0, 1], each given by what it is at its knots and
/// by its slopes at both ends.
///
/// Source   de Boor, A practical guide to splines, chapter IV: complete cubic spline interpolation.
class CompleteCubic {
  public:
    explicit CompleteCubic(int spans);

    [[nodiscard]] int spans() const { return spans_; }
    [[nodiscard]] const std::vector<double>& knots() const { return knots_; }
    /// How many data, and poles, a spline has.
    [[nodiscard]] int count() const { return spans_ + 3; }
    /// The mean of the inner knots of each pole.
    [[nodiscard]] double greville(int pole) const;

    /// Input    data: dimension x count(): value and slope at 0, values at the knots between, slope
    ///          and value at 1.
    /// Result   poles, dimension x count(); the first and the last are the values at the ends.
    [[nodiscard]] Eigen::MatrixXd poles(const Eigen::MatrixXd& data) const;
    [[nodiscard]] SplineCurve spline(const Eigen::MatrixXd& data) const;

  private:
    int spans_;
    std::vector<double> knots_;
    Eigen::MatrixXd to_poles_;
};

}  // namespace suture::concentric

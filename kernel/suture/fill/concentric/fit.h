#pragma once

#include "suture/spline/curve.h"

#include <Eigen/Core>

#include <functional>
#include <vector>

namespace suture::concentric {

/// A smooth function of one parameter as a B-spline.
struct FittedCurve {
    SplineCurve curve;
    double error = 0.0;  ///< largest distance at samples between the fitted ones
};

/// Where a function need not be smooth.
struct Break {
    double at = 0.0;
    bool tangent = false;  ///< its first derivative is continuous there
};

/// Breaks by increasing parameter, each once: a kink where any of them is one.
[[nodiscard]] std::vector<Break> sorted(std::vector<Break> breaks);

/// The interpolant at the Greville points of a clamped knot vector, with evenly spread knots
/// between the breaks. The ends are met exactly.
[[nodiscard]] SplineCurve interpolated(const std::function<Eigen::VectorXd(double)>& at,
                                       const std::vector<Break>& breaks, int degree, int spans);

/// `interpolated` with twice as many knots until the error is small enough. What is a polynomial of
/// that degree between breaks is met exactly.
///
/// Input    at: smooth between the breaks, of which the first and the last are its domain's ends,
///          and continuous there.
/// Result   the best one found where the accuracy was out of reach: the error tells.
[[nodiscard]] FittedCurve fit_curve(const std::function<Eigen::VectorXd(double)>& at,
                                    const std::vector<Break>& breaks, int degree, double accuracy);

}  // namespace suture::concentric

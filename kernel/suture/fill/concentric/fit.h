#pragma once

#include "suture/spline/curve.h"

#include <Eigen/Core>

#include <functional>

namespace suture::concentric {

/// A smooth function of one parameter as a B-spline.
struct FittedCurve {
    SplineCurve curve;
    double error = 0.0;  ///< largest distance at samples between the fitted ones
};

/// Interpolates at the Greville points of a clamped knot vector, with evenly spread knots between
/// the breaks, twice as many until the error is small enough. The ends are met exactly.
///
/// Input    at: smooth between the breaks, of which the first and the last are its domain's ends,
///          and continuous there.
/// Result   the best one found where the accuracy was out of reach: the error tells.
[[nodiscard]] FittedCurve fit_curve(const std::function<Eigen::VectorXd(double)>& at,
                                    const std::vector<double>& breaks, int degree, double accuracy);

}  // namespace suture::concentric

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

/// Where a function need not be smooth, or where a spline has a knot for another reason.
struct Break {
    double at = 0.0;
    int smooth = 0;  ///< so many derivatives are continuous there
};

/// Breaks by increasing parameter, each once: as smooth as the least smooth of them.
[[nodiscard]] std::vector<Break> sorted(std::vector<Break> breaks);

/// The spline with these breaks that interpolates at its Greville points. The ends are met exactly.
///
/// Input    at: continuous; breaks: the first and the last are its domain's ends.
[[nodiscard]] SplineCurve interpolated(const std::function<Eigen::VectorXd(double)>& at,
                                       const std::vector<Break>& breaks, int degree);

/// `interpolated` with further knots in the middle of all intervals whose error is too large, again
/// and again. What is a polynomial of that degree between breaks is met exactly.
///
/// Result   the best one found where the accuracy was out of reach: the error tells.
[[nodiscard]] FittedCurve fit_curve(const std::function<Eigen::VectorXd(double)>& at,
                                    std::vector<Break> breaks, int degree, double accuracy);

/// How far a curve misses what is wanted between two of its breaks, against what is allowed.
using Missed = std::function<double(const SplineCurve& curve, double from, double to)>;

/// Derivatives at the ends of a curve's domain.
struct EndSlopes {
    Eigen::VectorXd from, to;
};

/// The same by another measure, of which the error is the largest, and with slopes at the ends that
/// are met exactly: they stand for the Greville points next to the ends. Degree 3 or more.
[[nodiscard]] FittedCurve fit_curve(const std::function<Eigen::VectorXd(double)>& at,
                                    const EndSlopes& slopes, std::vector<Break> breaks, int degree,
                                    const Missed& missed);

}  // namespace suture::concentric

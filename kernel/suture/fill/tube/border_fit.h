#pragma once

#include "suture/base/tolerance.h"
#include "suture/fill/tube/border.h"
#include "suture/fill/tube/ring.h"

#include <Eigen/Core>

#include <vector>

namespace suture::tube {

/// The intervals of each side, in the parameter around.
using Divisions = std::vector<std::vector<double>>;

/// How the border and its outward tangents become quadratic splines around.
struct Way {
    enum class Pieces { Interpolated, Bezier, Taylor };
    enum class Join { AllAtOnce, Marching };
    Pieces pieces = Pieces::Interpolated;  ///< all at once, in the middle of each interval
    Join join = Join::AllAtOnce;           ///< of Bezier or Taylor pieces (stripe.h)
};

/// The border's two rows on a net with a double knot at each sharp corner: columns that interpolate
/// the border and its outward tangents in the middle of each interval, and at the corners.
///
/// Result   points and outward tangents of every column, 3 x columns each.
struct BorderRows {
    Ring ring;
    Eigen::Matrix3Xd points, outward;
    Eigen::Matrix2Xd plane;  ///< empty without a layout
};
[[nodiscard]] BorderRows fit_border(const Border& border, const Divisions& divisions,
                                    const Tolerance& tolerance, const Way& way);

/// How well a net with these rows meets the sides, on one interval.
struct BorderError {
    double gap = 0.0;    ///< from the neighbour's edge
    double angle = 0.0;  ///< from the neighbour's normal; only where the side asks for it
    double fit_gap = 0.0, fit_angle = 0.0;  ///< from Border::at: what more intervals make smaller
};
[[nodiscard]] std::vector<std::vector<BorderError>> measure_border(const Border& border,
                                                                   const Divisions& divisions,
                                                                   const BorderRows& rows);

/// Divides the sides until the border is met within the tolerance.
///
/// Input    first: the intervals next to the corners are no longer than this, if they turn there
/// Result   fewer divisions than the tolerance needs where kMostColumns are not enough
[[nodiscard]] Divisions divide(const Border& border, const Tolerance& tolerance, double first,
                               const Way& way);

}  // namespace suture::tube

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

}  // namespace suture::tube

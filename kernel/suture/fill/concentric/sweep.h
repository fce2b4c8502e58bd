#pragma once

#include "suture/fill/concentric/concentric_curve.h"
#include "suture/spline/curve.h"
#include "suture/spline/surface.h"

#include <vector>

namespace suture::concentric {

/// Straight pieces, each beginning where the last one ends, as a piecewise linear B-spline in the
/// plane.
[[nodiscard]] SplineCurve linear_spline(const std::vector<Course>& courses,
                                        const std::vector<Eigen::Vector2d>& nodes);

/// Both curves over the same knots and of the same degree: those of either.
///
/// Source   Martin & Cohen 2003, figure 7, steps 6 and 7.
void make_compatible(SplineCurve& a, SplineCurve& b);

/// The surface with these rows of poles along u, all over the same knots, and knots_v of the degree
/// that fits their number: of two rows a and b the sweep (1-t) a(s) + t b(s).
///
/// Source   Martin & Cohen 2003, figure 7, step 8.
[[nodiscard]] SplineSurface from_rows(const std::vector<SplineCurve>& rows,
                                      std::vector<double> knots_v);

}  // namespace suture::concentric

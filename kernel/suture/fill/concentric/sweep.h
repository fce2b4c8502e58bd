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
void make_compatible(SplineCurve& a, SplineCurve& b);

/// The sweep surface (1-t) a(s) + t b(s) of two curves in space: bidegree (p, 1), s along u, t
/// along v. The control points of `a` are its first row, so that `a` is met exactly.
///
/// Source   Martin & Cohen 2003, figure 7, steps 6 to 8.
[[nodiscard]] SplineSurface sweep(SplineCurve a, SplineCurve b);

/// The surface with these rows of poles, all over the same knots, and knots_v of the degree that
/// fits their number.
[[nodiscard]] SplineSurface from_rows(const std::vector<SplineCurve>& rows,
                                      std::vector<double> knots_v);

}  // namespace suture::concentric

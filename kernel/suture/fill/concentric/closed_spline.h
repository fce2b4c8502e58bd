#pragma once

#include "suture/spline/curve.h"

#include <Eigen/Core>

#include <vector>

namespace suture::concentric {

/// A closed planar B-spline curve, cyclic: pole i is a vertex of the control polygon and lives on
/// [t_{i-1}, t_{i+degree}], where the knots t_0 <= ... <= t_n = t_0 + period repeat with the
/// period. Knots that stand `degree` times are corners. Degree 1 is the polygon itself, vertex i at
/// t_i.
struct ClosedSpline {
    int degree = 1;
    std::vector<double> knots;  ///< t_0..t_n: one more than poles
    Eigen::Matrix2Xd poles;

    [[nodiscard]] int count() const { return static_cast<int>(poles.cols()); }
    [[nodiscard]] double begin() const { return knots.front(); }
    [[nodiscard]] double period() const { return knots.back() - knots.front(); }
};

/// The closed curve made of clamped curves of one degree, each of which begins where the last ends.
[[nodiscard]] ClosedSpline closed_from(const std::vector<SplineCurve>& sides);

/// The curve over one period as an ordinary one, with its knots single at the ends.
[[nodiscard]] SplineCurve unrolled(const ClosedSpline& curve);

/// The curve over one period with all its knots at the ends: poles 0 and last are curve points.
[[nodiscard]] SplineCurve clamped(const ClosedSpline& curve);

/// The same curve with further knots, anywhere in [begin, begin + period).
[[nodiscard]] ClosedSpline with_knots(const ClosedSpline& curve, const std::vector<double>& more);

/// The parameter of each vertex of the control polygon, increasing: its pole's Greville abscissa.
[[nodiscard]] std::vector<double> nodal_parameters(const ClosedSpline& curve);

/// Parameters in [begin, begin + period) where the curve is only continuous: its corners.
[[nodiscard]] std::vector<double> corner_parameters(const ClosedSpline& curve);

}  // namespace suture::concentric

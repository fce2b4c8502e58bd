#pragma once

#include "suture/occ/handle.h"

#include <Eigen/Core>

#include <Geom2d_Curve.hxx>
#include <Geom_Surface.hxx>

#include <functional>

namespace suture {

/// How near a fitted pcurve comes to the curve it stands for, as a fraction of the hole's diameter:
/// well below any gap that is ever asked for, and above the rounding errors of an inversion.
inline constexpr double kPcurveAccuracy = 1e-9;

/// How a pcurve that is no line is written.
enum class Pieces {
    Few,   ///< as one polynomial, where a degree up to 13 is near enough: few bytes in a file
    Cubic  ///< in cubic pieces, into which knots are put easily
};

/// A curve on a surface as OCCT keeps it: a line where it is one, else one polynomial if that is
/// asked for and near enough, else an interpolating C2 cubic B-spline with as many points as the
/// accuracy needs.
///
/// Input    at: (u, v) at the edge's parameter t in [first, last]; accuracy: largest distance in
///          space, model units.
/// Result   defined on [first, last] with the edge's own parameter. Where the accuracy cannot be
///          reached with kMostPoints points the best curve found; callers measure the distance.
[[nodiscard]] occ::Handle<Geom2d_Curve> fit_pcurve(
    const std::function<Eigen::Vector2d(double t)>& at, double first, double last,
    const Geom_Surface& surface, double accuracy, Pieces pieces = Pieces::Cubic);

}  // namespace suture

#pragma once

#include "suture/occ/handle.h"

#include <Eigen/Core>

#include <Geom_Curve.hxx>
#include <Geom_Surface.hxx>

#include <array>
#include <functional>

namespace suture {

/// Where a curve's points have their feet on a surface: the nearest points of the surface, so that
/// the distance between the two at one parameter is the gap and nothing else. A layout says only
/// about where that is.
///
/// Input    about: (u, v) at the curve's parameter t in [first, last]; ends: where the result has
///          to begin and to end, since there the curves of neighbouring edges meet.
/// Result   (u, v) of the feet, but for the last fifth before either end, which leads over to that.
///          On a border of the surface it stays there. Where the surface is singular, or the foot
///          is not found, `about` again.
[[nodiscard]] std::function<Eigen::Vector2d(double t)> foot_points(
    const occ::Handle<Geom_Curve>& curve, double first, double last,
    const occ::Handle<Geom_Surface>& surface, std::function<Eigen::Vector2d(double t)> about,
    const std::array<Eigen::Vector2d, 2>& ends);

/// The foot of one point; `about` itself where it is not found.
[[nodiscard]] Eigen::Vector2d foot_point(const Eigen::Vector3d& point, const Geom_Surface& surface,
                                         const Eigen::Vector2d& about);

}  // namespace suture

#pragma once

#include "suture/base/tolerance.h"
#include "suture/fill/concentric/assemble.h"
#include "suture/fill/concentric/boundary.h"
#include "suture/fill/concentric/height.h"
#include "suture/model/ribbon.h"

namespace suture::concentric {

/// The concentric map carried into space, tangent to the hole's neighbours:
///     S(s,t) = (1-t) gamma + t c  in the plane, and above it the cubic in t that has
///     the height of gamma and the slope of the neighbour's tangent plane at t = 0,
///     the height and slope of a smooth height field at t = 1.
/// All spokes that end at one point of the axis are tangent to one plane there: the surface has a
/// tangent plane along the axis. Across the spokes to nodes, where c turns, and to the hole's
/// corners, where the sides turn, its normals differ by terms of third order: none on quadratic
/// surfaces, and the less the slower c is at its nodes, where it nearly rests.
///
/// Source   ours: what Martin & Cohen 2003 name as their next step.
class Lift {
  public:
    /// Refuses  a neighbour whose normal leans by more than kMostLean from the loop's own.
    [[nodiscard]] static Result<Lift> make(const Hole& hole, const Boundary& boundary,
                                           const ConcentricCurve& axis, const Tolerance& tolerance);

    /// Bidegree (5, 3) or more in s.
    [[nodiscard]] SplineSurface surface(const Region& region);
    [[nodiscard]] Eigen::Vector3d vertex(int node) const;

    /// How far the surfaces made so far miss the cubics that they stand for, in model units.
    [[nodiscard]] double error() const { return error_; }

  private:
    Lift(const Hole& hole, const Boundary& boundary, const ConcentricCurve& axis, HeightField field,
         double accuracy)
        : hole_(hole),
          boundary_(boundary),
          axis_(axis),
          field_(std::move(field)),
          accuracy_(accuracy) {}

    const Hole& hole_;
    const Boundary& boundary_;
    const ConcentricCurve& axis_;
    HeightField field_;
    double accuracy_;
    double error_ = 0.0;

    [[nodiscard]] SplineCurve axis_row(const Region& region);
    [[nodiscard]] double boundary_slope(double s, const Eigen::Vector2d& spoke) const;
    [[nodiscard]] Eigen::Vector2d boundary_gradient(int side, double s) const;
};

}  // namespace suture::concentric

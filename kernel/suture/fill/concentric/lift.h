#pragma once

#include "suture/base/tolerance.h"
#include "suture/fill/concentric/assemble.h"
#include "suture/fill/concentric/boundary.h"
#include "suture/fill/concentric/complete_cubic.h"
#include "suture/fill/concentric/fit.h"
#include "suture/fill/concentric/height.h"
#include "suture/fill/concentric/lifted_axis.h"
#include "suture/model/ribbon.h"

#include <array>
#include <vector>

namespace suture::concentric {

/// The concentric map carried into space, tangent to the hole's neighbours:
///     S(s,t) = (1-t) gamma + t c  in the plane, and above it the height
///     z(s,t) = h((1-t) gamma + t c) + H0(t) r0(s) + H1(t) r1(s)
/// where h is a smooth height field fitted to the loop and its neighbours' tangent planes, r0 and
/// r1 are what it misses of the height of gamma and of the slope along the spoke there, and H0, H1
/// are the cubics of Hermite that begin with value (slope) 1 and end with value and slope 0. z is a
/// cubic spline in t. As h is one function of the plane, surfaces on both sides of a spoke or of
/// the axis have the same normals, but for what the small r0 and r1 do across spokes.
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

    /// How far the surfaces made so far miss the heights that they stand for, in model units.
    [[nodiscard]] double error() const { return error_; }
    /// How far they may.
    [[nodiscard]] double accuracy() const { return accuracy_; }

  private:
    Lift(const Hole& hole, const Boundary& boundary, const ConcentricCurve& axis, HeightField field,
         const Tolerance& tolerance);

    const Hole& hole_;
    const Boundary& boundary_;
    const ConcentricCurve& axis_;
    std::vector<SplineCurve> sides_;  ///< in the frame's coordinates
    HeightField field_;
    double accuracy_;  ///< of heights
    LiftedAxis lifted_axis_;
    CompleteCubic radial_{1};
    /// conflicts_[i]: by how much the gradient of h misses the neighbour's at either end of side i.
    std::vector<std::array<double, 2>> conflicts_;
    double error_ = 0.0;

    /// A spoke in the plane, and what z is like at its ends.
    struct Spoke {
        Eigen::Vector3d from;
        Eigen::Vector2d along;
        double start_slope = 0.0, end_slope = 0.0, end_height = 0.0;
        double missed_height = 0.0, missed_slope = 0.0;
    };
    [[nodiscard]] Spoke spoke(const SplineCurve& gamma, const Course& course, double s) const;
    [[nodiscard]] double height(const Spoke& spoke, double t) const;
    /// As CompleteCubic wants them, from the slope at t = 0 on.
    [[nodiscard]] Eigen::VectorXd heights(const Spoke& spoke, const CompleteCubic& radial) const;
    [[nodiscard]] Eigen::Vector2d missed_gradient(int side, double s) const;
    [[nodiscard]] SplineCurve local(SplineCurve curve) const;
    [[nodiscard]] std::vector<Break> breaks(const SplineCurve& gamma, const Region& region) const;
    void choose_radial_spans();
};

}  // namespace suture::concentric

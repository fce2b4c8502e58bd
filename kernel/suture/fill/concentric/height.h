#pragma once

#include "suture/base/tolerance.h"
#include "suture/fill/concentric/boundary.h"
#include "suture/fill/concentric/concentric_curve.h"
#include "suture/model/ribbon.h"

#include <Eigen/Core>

#include <vector>

namespace suture::concentric {

/// The share of a side, at a corner, over which the surface leaves the neighbour's slopes for the
/// field's own.
inline constexpr double kFade = 0.1;

/// What a height field has to meet at one point of the plane.
struct HeightSample {
    Eigen::Vector2d at;
    double height = 0.0;
    /// A unit direction and the slope in it; a zero direction where the slope is free.
    Eigen::Vector2d direction = Eigen::Vector2d::Zero();
    double slope = 0.0;
};

/// The smooth function over the plane with given heights and slopes: a polyharmonic Hermite
/// interpolant
///     z(x) = sum_j a_j phi(x - x_j) - b_j d_j . grad phi(x - x_j) + quadratic,   phi = |x|^5,
/// which leaves quadratic surfaces as they are.
///
/// Source   Wendland, Scattered data approximation, 2005, chapter 16.
class HeightField {
  public:
    explicit HeightField(std::vector<HeightSample> samples);

    /// The field through samples of a loop, and tangent to its neighbours there where that is
    /// wanted: with as many samples as make it so between them as well, up to kMostSamples.
    [[nodiscard]] static HeightField over(const Hole& hole, const Boundary& boundary,
                                          const Tolerance& tolerance);

    [[nodiscard]] double height(const Eigen::Vector2d& x) const;
    [[nodiscard]] Eigen::Vector2d gradient(const Eigen::Vector2d& x) const;
    /// Of the axis' nodes from the samples.
    [[nodiscard]] double least_distance(const ConcentricCurve& axis) const;

  private:
    std::vector<HeightSample> samples_;  ///< in units of `scale_` about `centre_`
    Eigen::VectorXd weights_;
    Eigen::Vector2d centre_ = Eigen::Vector2d::Zero();
    double scale_ = 1.0;

    [[nodiscard]] Eigen::Vector2d local(const Eigen::Vector2d& x) const {
        return (x - centre_) / scale_;
    }
};

}  // namespace suture::concentric

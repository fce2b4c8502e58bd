#pragma once

#include "suture/fill/manifold/series.h"
#include "suture/fill/manifold/star.h"

#include <Eigen/Core>

#include <array>

namespace suture::manifold {

/// A point of X as two series.
using PlaneSeries = std::array<Series<1>, 2>;

/// How a unit square lies in the middle of X, between the spokes m and m + 1 and the inner ends of
/// the border zones of these sides. The same for all sides, turned by alpha.
///
///       (0,1) spoke m+1       (1,1) corner where both border zones meet
///         +--------------------+
///         |                    |   u = 0, v = 0: the spokes, from the middle O of X
///         |                    |   u = 1, v = 1: x - mu(y) = inner() of the sides m and m + 1
///         +--------------------+
///       (0,0) O               (1,0) spoke m
///
/// A bicubically blended Coons patch: its borders are those curves, and across them its derivatives
/// are such that joins can be made exactly:
///   u = 1:  the constant vector `pull()` v_m, along which F does not bend;
///   v = 0:  blend(u) g'(u) v_m + (something) across, mirrored on the other side of the spoke.
class QuadMap {
  public:
    explicit QuadMap(const Star& star);

    /// The map about (u, v), in X, for the square that lies between the spokes m and m + 1.
    /// towards: the sides of (u, v), +1 or -1, on which the series is wanted.
    [[nodiscard]] PlaneSeries expand(int m, const Eigen::Vector2d& at,
                                     const Eigen::Vector2d& towards, int order) const;
    [[nodiscard]] Eigen::Vector2d at(int m, const Eigen::Vector2d& at) const;

    /// What of the cross derivative at a spoke runs along it, relative to the spoke's own
    /// derivative: cos(alpha) (1 - u)^2, as coefficients of powers of u.
    [[nodiscard]] const Eigen::VectorXd& blend() const { return blend_; }
    /// y at (1,1): sides are parametrised by y = reach() v.
    [[nodiscard]] double reach() const { return reach_; }

  private:
    Star star_;
    double reach_ = 0.0;
    double pull_ = 0.0;
    Eigen::VectorXd spoke_;  ///< g: the spoke is g(u) v_m
    Eigen::VectorXd blend_;
    Eigen::VectorXd along_, across_;  ///< of the cross derivative at a spoke
    /// corner_[a][b]: what the four curves a in u have in common with the four curves b in v
    std::array<std::array<Eigen::Vector2d, 4>, 4> corner_;

    [[nodiscard]] std::array<PlaneSeries, 4> curves(const Series<1>& t, double towards) const;
};

}  // namespace suture::manifold

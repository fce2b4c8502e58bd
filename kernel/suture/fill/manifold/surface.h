#pragma once

#include "suture/fill/manifold/series.h"
#include "suture/fill/manifold/star.h"

#include <Eigen/Core>

#include <vector>

namespace suture::manifold {

/// The control points that act at a point of X, and their shares w N / sum w N.
struct Shares {
    std::vector<int> points;
    Eigen::RowVectorXd weights;
};

[[nodiscard]] Shares shares_at(const Star& star, const Eigen::Vector2d& p);

/// The C^k surface S(p) = sum w N P / sum w N over a star with given control points.
///
/// Source    section 6.1: one B-spline of homogeneous control points (w P, w) a side, zero where a
///           chart is discarded; their sum is projected.
class StarSurface {
  public:
    /// Input    points: one column for each of the star's control points.
    StarSurface(Star star, const Eigen::Matrix3Xd& points);

    /// The same star, moved control points: nothing else is computed again.
    void move(const Eigen::Matrix3Xd& points);

    [[nodiscard]] const Star& star() const { return star_; }
    [[nodiscard]] const Eigen::Matrix3Xd& points() const { return points_; }

    /// (sum w N P, sum w N) at a point of X, by de Boor's algorithm.
    [[nodiscard]] Eigen::Vector4d sum(const Eigen::Vector2d& p) const;
    [[nodiscard]] Eigen::Vector3d at(const Eigen::Vector2d& p) const;

    /// Taylor series of (sum w N P, sum w N) along a path (x, y) into X that is itself a series:
    /// exact where its order is the polynomials' degree.
    ///
    /// Input    towards: a point next to (x, y): across a knot the series is that on its side.
    [[nodiscard]] Series<4> expand_sum(const Series<1>& x, const Series<1>& y,
                                       const Eigen::Vector2d& towards) const;
    /// Taylor series of S along such a path.
    [[nodiscard]] Series<3> expand(const Series<1>& x, const Series<1>& y,
                                   const Eigen::Vector2d& towards) const;
    /// The same by x and y themselves.
    [[nodiscard]] Series<3> expand(const Eigen::Vector2d& p, int order) const;

  private:
    Star star_;
    Eigen::Matrix3Xd points_;
    std::vector<Eigen::Matrix4Xd> nets_;  ///< of side m: charts_x x charts_y, x fastest

    void add_side(int m, const Eigen::Vector2d& p, Eigen::Vector4d& sum) const;
};

}  // namespace suture::manifold

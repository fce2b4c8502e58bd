#pragma once

#include "suture/base/result.h"

#include <Eigen/Core>

#include <vector>

namespace suture::manifold {

/// Knots along a ray v_m and along the middle part C_m of a side, where they are given: else both
/// are evenly spaced, as in the paper.
struct GivenKnots {
    /// Of a ray: s + 1 increasing numbers from 0. The h auxiliary knots beyond either end repeat
    /// the outermost spacing.
    std::vector<double> depth;
    /// Of a side's middle: r + 1 increasing numbers from -1 to 1; empty: evenly spaced.
    std::vector<double> middle;
};

/// What a star-shaped patch is made of.
struct StarSize {
    int k = 2;                      ///< order of continuity
    int layers = 0;                 ///< s: intervals of X along a ray
    std::vector<int> columns;       ///< r_m: intervals of X in the middle of side m; n = size
    double aperture = 0.0;          ///< f; 0: the default
    std::vector<GivenKnots> given;  ///< one a side, or none
};

/// The regular n-sided mesh X, its charts and their control points: everything that does not depend
/// on where the control points are.
///
/// Side m is seen in its own frame: v_m is the x-axis. The map F takes (x, y) to (x - mu(|y|), y),
/// which makes the side a rectangular grid with the knots knots_x(m), knots_y(m):
///
///      y ^     L_m       | i: layers away from the central face, j: along the side
///        |---------------|
///        |     C_m       |   side m shares L_m with side m + 1 and L_{m-1} with side m - 1
///        |---------------|
///        |     L_{m-1}   |
///        +---------------+--> x - mu(y)
///
/// Source    Cotrina-Navau, Pla-Garcia, Vigo-Anglada, N-sided patches with B-spline boundaries,
///           report LSI-01-55-R, 2001, sections 3 and 4. Departures: docs/methods/manifold.md.
class Star {
  public:
    /// Refuses  n < 3, k < 0, a side without an interval, too few layers, knots that do not
    ///          increase, an aperture that is not positive or not below its bound.
    [[nodiscard]] static Result<Star> make(const StarSize& size);

    /// Layers that a patch of order k needs for a border zone that is one B-spline.
    [[nodiscard]] static int least_layers(int k, int n);
    /// Apertures have to stay below h / (2 cos(alpha / 2)) (section 7).
    [[nodiscard]] static double aperture_bound(int k, int n);
    /// f = r makes all knots uniform; where that is not possible, 0.8 of the bound.
    [[nodiscard]] static double default_aperture(int k, const std::vector<int>& columns);

    [[nodiscard]] int k() const { return size_.k; }
    [[nodiscard]] int degree() const { return size_.k + 1; }
    [[nodiscard]] int h() const { return size_.k / 2 + 1; }
    [[nodiscard]] int n() const { return static_cast<int>(size_.columns.size()); }
    [[nodiscard]] int layers() const { return size_.layers; }
    [[nodiscard]] int columns(int m) const { return size_.columns[index(m)]; }
    [[nodiscard]] double aperture() const { return size_.aperture; }
    [[nodiscard]] double alpha() const { return alpha_; }
    [[nodiscard]] double f_x() const { return f_x_; }
    [[nodiscard]] double f_y() const { return f_y_; }

    /// Charts of a side across (i) and along (j) it.
    [[nodiscard]] int charts_x() const { return size_.layers + 1 - odd(); }
    [[nodiscard]] int charts_y(int m) const { return 2 * size_.layers + columns(m) + 1 - odd(); }
    [[nodiscard]] const std::vector<double>& knots_x(int m) const { return knots_x_[index(m)]; }
    [[nodiscard]] const std::vector<double>& knots_y(int m) const { return knots_y_[index(m)]; }

    /// Control points of all charts: those that two sides share have one number.
    [[nodiscard]] int count() const { return first_.back(); }
    [[nodiscard]] int point_of(int m, int i, int j) const;
    /// Whether side m has a chart of its own at (i, j): conditions (7) and (8).
    [[nodiscard]] bool kept(int m, int i, int j) const;
    /// 1 over the number of charts of a control point.
    [[nodiscard]] double weight(int point) const { return weights_[point]; }

    /// Where the surface is the plain B-spline of side m (Theorem 1, with the true bounds): x - mu
    /// from `inner`, the same for all sides, to `border(m)`, the border of the patch.
    [[nodiscard]] double inner() const { return inner_; }
    [[nodiscard]] double border(int m) const;

    /// mu and its polynomial piece about y: coefficients of the powers of (t - y). `towards` is a
    /// point on the side whose piece is wanted.
    [[nodiscard]] double mu(double y) const;
    [[nodiscard]] Eigen::VectorXd mu_series(double y, double towards, int order) const;

    /// From X to the frame of side m, and back.
    [[nodiscard]] Eigen::Vector2d to_side(int m, const Eigen::Vector2d& p) const;
    [[nodiscard]] Eigen::Vector2d from_side(int m, const Eigen::Vector2d& p) const;

    /// The middle of the chart (i, j) of side m in X: the vertex or face that it belongs to.
    [[nodiscard]] Eigen::Vector2d chart_centre(int m, int i, int j) const;

  private:
    StarSize size_;
    double alpha_ = 0.0;
    double inner_ = 0.0;
    double f_x_ = 0.0;
    double f_y_ = 0.0;
    double cot_ = 0.0;                   ///< of alpha
    std::vector<Eigen::Vector2d> rays_;  ///< v_m
    Eigen::VectorXd q_;                  ///< of even powers: mu's bulge
    std::vector<std::vector<double>> knots_x_, knots_y_;
    std::vector<int> first_;  ///< number of side m's first control point; the count at the end
    Eigen::VectorXd weights_;

    [[nodiscard]] int odd() const { return size_.k % 2; }
    [[nodiscard]] std::size_t index(int m) const {
        return static_cast<std::size_t>(((m % n()) + n()) % n());
    }
    void make_knots();
    void make_points();
};

}  // namespace suture::manifold

#pragma once

#include "suture/fill/manifold/border_fit.h"
#include "suture/spline/surface.h"

#include <Eigen/Core>

#include <vector>

namespace suture::manifold {

/// The case n = 0, which the paper leaves open: a ring of control points closed at an apex.
///
/// A B-spline of degree k + 1 in x (from the apex, x = 0, to the border, x = layers) and in y (all
/// the way around, 0 to 2 pi), C^k everywhere but at the apex. There the first row of poles is one
/// point P and the second P + c_j A + s_j B, with (c_j, s_j) the control points of a closed spline
/// around the origin: every radial derivative lies in the plane of A and B, so that the surface has
/// a tangent plane at the apex, too.
///
/// The control points are P, A, B and then the rows from the third on.
class Ring {
  public:
    Ring(int k, int layers, int columns);

    [[nodiscard]] int layers() const { return layers_; }
    [[nodiscard]] int count() const { return 3 + (rows() - 2) * columns_; }

    /// The energy is the integral over the unit disc of |d^3 S|^2, by polar coordinates.
    [[nodiscard]] BorderModel border_model(double diameter) const;

    /// u is x, v is y.
    [[nodiscard]] SplineSurface spline(const Eigen::Matrix3Xd& points) const;

  private:
    int k_, layers_, columns_;
    std::vector<double> knots_x_, knots_y_;

    [[nodiscard]] int degree() const { return k_ + 1; }
    [[nodiscard]] int rows() const { return layers_ + degree(); }

    /// A pole (i, j) in terms of the control points.
    void add_pole(int i, int j, const Eigen::VectorXd& weights, BorderRow& row) const;
    [[nodiscard]] BorderRow row_at(double y) const;
    [[nodiscard]] Eigen::SparseMatrix<double> energy() const;
};

}  // namespace suture::manifold

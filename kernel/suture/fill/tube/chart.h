#pragma once

#include "suture/fill/tube/net.h"

#include <Eigen/Core>

namespace suture::tube {

/// The tube over the plane: a plane point for each control point of a net, so that (u, v) has a
/// place (x, y) and a surface can be seen as a function of it.
struct Chart {
    Eigen::Matrix2Xd points;  ///< as Net::points

    /// Rays from the origin to the border, run through evenly. As in the net itself every row but
    /// the two last is smooth at a double knot.
    ///
    /// Input    border: where the columns end in the plane, 2 x columns.
    [[nodiscard]] static Chart radial(const Net& net, const Eigen::Matrix2Xd& border);
};

/// The quadratic form of the thin plate in the chart, integral of |S_xx|^2 + 2 |S_xy|^2 + |S_yy|^2
/// dx dy, on a net's points; by Gauss's rule on each patch. Affine images of the chart have none,
/// and the pole is no singular place of it.
///
/// Source   Greiner's data-dependent functionals, which the paper (section 5) points to.
[[nodiscard]] RealSparse plate_matrix(const Net& net, const Chart& chart);

}  // namespace suture::tube

#pragma once

#include "suture/fill/tube/ring.h"
#include "suture/spline/surface.h"

#include <Eigen/Core>

#include <vector>

namespace suture::tube {

inline constexpr int kDegreeU = 3;

/// The control net of a tube: cubic and clamped from the pole (u = 0) to the border of the hole,
/// quadratic around it.
///
///   row 0          the pole, every column
///   row 1          pole + (h0 / 3) D_j: the end tangents D_j
///   rows between   free
///   last but one   c_j - (h_last / 3) d_j: the outward tangents d_j at the border
///   last           c_j: the border
struct Net {
    std::vector<double> knots_u;
    Ring ring;
    Eigen::Matrix3Xd points;  ///< rows() x columns(), rows fastest

    Net(std::vector<double> across, Ring around);

    [[nodiscard]] int rows() const { return static_cast<int>(knots_u.size()) - kDegreeU - 1; }
    [[nodiscard]] int columns() const { return ring.columns(); }
    [[nodiscard]] double border() const { return knots_u.back(); }
    [[nodiscard]] double first_step() const;  ///< h0
    [[nodiscard]] double last_step() const;
    [[nodiscard]] int index(int row, int column) const {
        return row + rows() * ring.wrapped(column);
    }
    [[nodiscard]] auto point(int row, int column) { return points.col(index(row, column)); }
    [[nodiscard]] auto point(int row, int column) const { return points.col(index(row, column)); }
};

/// Clamped cubic knots on [0, 2]: one inner knot at 1 and `layers` more, each half as far from
/// the border as the one before.
[[nodiscard]] std::vector<double> knots_across(int layers);

/// The tangent at the pole along column j.
[[nodiscard]] Eigen::Vector3d end_tangent(const Net& net, int column);

/// Point and derivatives on one interval around, up to and with its ends.
[[nodiscard]] SurfaceJet evaluate(const Net& net, double u, int interval, double v);

/// The same surface as an open one, cut at v = 0: its first and last column agree. Exact.
[[nodiscard]] SplineSurface to_surface(const Net& net);

}  // namespace suture::tube

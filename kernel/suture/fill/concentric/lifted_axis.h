#pragma once

#include "suture/fill/concentric/concentric_curve.h"
#include "suture/fill/concentric/height.h"
#include "suture/spline/curve.h"

#include <Eigen/Core>

#include <map>
#include <utility>
#include <vector>

namespace suture::concentric {

/// The concentric axis in space, with a tangent plane at every point of it: both are splines over
/// the axis' edges, and the slope along an edge is the derivative of its own height. So all that
/// ends there has exactly one tangent plane, even where spokes nearly run along the axis.
class LiftedAxis {
  public:
    /// Input    accuracy: of heights, in model units; angular: of slopes.
    LiftedAxis(const ConcentricCurve& axis, const HeightField& field, double accuracy,
               double angular);

    struct Point {
        double height = 0.0;
        Eigen::Vector2d gradient;
    };
    /// On a course, at one of its parameters. Both ways along an edge give the same.
    [[nodiscard]] Point at(const Course& course, double s) const;
    [[nodiscard]] double height(int node) const { return nodes_.at(node).height; }

    /// Parameters inside of a course between which `at` is polynomial; it is smooth there.
    [[nodiscard]] std::vector<double> breaks(const Course& course) const;

    /// How far the splines miss the height field, in model units.
    [[nodiscard]] double error() const { return error_; }

  private:
    /// From the node of smaller number, on [0, 1].
    struct Edge {
        SplineCurve height;
        SplineCurve across;  ///< slope to the left
        int spans = 1;
        Eigen::Vector2d along;  ///< to the other node
    };
    using Ends = std::pair<int, int>;

    std::map<int, Point> nodes_;
    std::map<Ends, Edge> edges_;
    double error_ = 0.0;
};

}  // namespace suture::concentric

#pragma once

#include "suture/spline/curve.h"

#include <Eigen/Core>

#include <vector>

namespace suture::concentric {

/// Parameters nearer to each other than this are one. Every side of the boundary is 1 long.
inline constexpr double kSameParameter = 1e-8;

/// Where the concentric curve stands at a node of the concentric axis: for one parameter, or for as
/// long as the boundary's part that belongs to a cut branch lasts.
struct Stop {
    int node = 0;
    double from = 0.0;
    double to = 0.0;
};

/// The concentric curve c(s): straight from each stop to the next, once around the axis, each edge
/// of it once in each direction. Cyclic with the boundary's period.
struct ConcentricCurve {
    std::vector<Eigen::Vector2d> nodes;
    std::vector<Stop> stops;  ///< by increasing parameter
    double period = 0.0;

    [[nodiscard]] int count() const { return static_cast<int>(stops.size()); }
    /// Stop k, k < 2 count(), with parameters that go on beyond the period.
    [[nodiscard]] Stop stop(int k) const;
    [[nodiscard]] const Eigen::Vector2d& node(const Stop& stop) const {
        return nodes[static_cast<std::size_t>(stop.node)];
    }
};

/// How many nodes the axis has.
[[nodiscard]] int used_nodes(const ConcentricCurve& curve);

/// The point at a parameter.
[[nodiscard]] Eigen::Vector2d evaluate(const ConcentricCurve& curve, double s);

/// Makes the point at a parameter a node: on both ways along its edge of the axis, so that what
/// meets there on both sides does so in a vertex (condition (b) of Definition 1).
///
/// Result   the node's number.
int insert_node(ConcentricCurve& curve, double s);

/// One straight piece of the curve, which may be a point.
struct Course {
    double from = 0.0;
    double to = 0.0;
    int start = 0;  ///< node
    int end = 0;
};

/// The pieces over [begin, begin + period], which begins with a stop or inside of a piece; pieces
/// of no length are left out.
[[nodiscard]] std::vector<Course> courses(const ConcentricCurve& curve);

}  // namespace suture::concentric

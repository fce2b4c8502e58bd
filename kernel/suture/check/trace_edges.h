#pragma once

#include "suture/base/progress.h"
#include "suture/base/result.h"

#include <Eigen/Core>

#include <TopoDS_Shape.hxx>

#include <array>
#include <vector>

namespace suture {

/// The figures of the check at one point of an edge, to be drawn. What is not known is a NaN.
struct TracePoint {
    double along = 0.0;  ///< part of the edge's length, 0 to 1
    Eigen::Vector3d point = Eigen::Vector3d::Zero();
    double gap = 0.0, angle = 0.0;          ///< angle in radians
    std::array<double, 2> curvature = {};   ///< of both faces, perpendicular to the edge
    std::array<Eigen::Vector3d, 2> normal;  ///< outward, of both faces
};

struct EdgeTrace {
    int edge = 0;  ///< EdgeN, 1-based
    std::vector<TracePoint> points;
};

/// The figures of edges at evenly spread points, both ends included.
///
/// Input    edges: 1-based EdgeN of edges between two faces; most: points of one edge, at least 2.
///          Straight edges between planes get two.
/// Refuses  a cancelled run. An edge that cannot be evaluated has no points.
[[nodiscard]] Result<std::vector<EdgeTrace>> trace_edges(const TopoDS_Shape& shape,
                                                         const std::vector<int>& edges, int most,
                                                         const Progress& progress);

}  // namespace suture

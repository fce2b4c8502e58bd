#pragma once

#include "suture/detect/shell_graph.h"
#include "suture/sew/places.h"

#include <BRepAdaptor_Curve.hxx>

#include <array>
#include <vector>

namespace suture {

/// A free edge as the sewing sees it.
struct FreeEdge {
    int use = -1;  ///< index into ShellGraph::uses
    int face = -1;
    int group = 0;  ///< the innermost compound that the face lies in
    BRepAdaptor_Curve curve;
    double length = 0.0;
    double accuracy = 0.0;      ///< the largest tolerance of the edge and its vertices
    std::array<int, 2> ends{};  ///< points of Places, in the curve's direction

    [[nodiscard]] double first() const { return curve.FirstParameter(); }
    [[nodiscard]] double last() const { return curve.LastParameter(); }
    [[nodiscard]] Eigen::Vector3d point(double parameter) const;
};

/// The free edges of a shape, in the order of the graph's uses; edges without a curve or without
/// vertices are left out. Their ends are added to `places`, each vertex once.
///
/// Input  most: tolerances that are larger count as this.
[[nodiscard]] std::vector<FreeEdge> find_free_edges(const TopoDS_Shape& shape,
                                                    const ShellGraph& graph, double most,
                                                    Places& places);

/// The point of a curve nearest to p between two parameters.
///
/// Input   guess: a parameter near it.
struct FootPoint {
    double parameter = 0.0;
    double distance = 0.0;
};
[[nodiscard]] FootPoint foot_point(const BRepAdaptor_Curve& curve, double first, double last,
                                   const Eigen::Vector3d& p, double guess);

}  // namespace suture

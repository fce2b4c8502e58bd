#pragma once

#include <Eigen/Core>

#include <TopoDS_Edge.hxx>

#include <functional>
#include <memory>
#include <vector>

namespace suture {

/// A point of an edge that lies nearest to some other point.
struct NearPoint {
    int edge = -1;  ///< index of the edge in the field, -1: there is none
    double distance = 0.0;
    double parameter = 0.0;  ///< on the edge's curve
};

/// Finds the nearest of many edges.
class EdgeField {
  public:
    explicit EdgeField(const std::vector<TopoDS_Edge>& edges);
    ~EdgeField();
    EdgeField(const EdgeField&) = delete;
    EdgeField& operator=(const EdgeField&) = delete;

    /// The nearest point of the edges for which `wanted` is true. The distance is that to the curve
    /// itself. Edges farther away than `limit` need not be found.
    [[nodiscard]] NearPoint nearest(const Eigen::Vector3d& point,
                                    const std::function<bool(int edge)>& wanted,
                                    double limit) const;

    /// t in [0,1] along the edge's curve.
    [[nodiscard]] Eigen::Vector3d point(int edge, double t) const;
    [[nodiscard]] double length(int edge) const;

  private:
    struct Index;
    std::unique_ptr<Index> index_;
};

}  // namespace suture

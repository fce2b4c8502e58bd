#pragma once

#include <Eigen/Core>

#include <TopoDS_Vertex.hxx>

#include <vector>

namespace suture {

/// What lies apart by this many times the sum of both tolerances is as near as the file itself
/// claims to be good for, and half as much for how that was measured.
inline constexpr double kAccuracy = 1.5;

/// Tolerances of more than this share of the model's diagonal say that something is wrong, and
/// nothing of how good it is.
inline constexpr double kMostAccuracy = 1e-3;

/// The ends of free edges, and the points at which free edges are to be cut. Those that are to
/// become one vertex are one place.
class Places {
  public:
    /// Two points that may be one place.
    struct Link {
        int a = 0;
        int b = 0;
        double distance = 0.0;
    };

    /// Input   vertex: null where an edge is to be cut; accuracy: what it is good for.
    /// Result  the number of the new point.
    int add(const Eigen::Vector3d& point, const TopoDS_Vertex& vertex, double accuracy);

    /// How far two points may lie apart to be one place: the limit, and what the file itself says
    /// that its vertices are good for.
    [[nodiscard]] double reach(int a, int b, double limit) const {
        return limit + kAccuracy * (accuracies_[a] + accuracies_[b]);
    }

    /// The place that a point belongs to, as the number of one of its points.
    [[nodiscard]] int of(int point) const;

    /// Makes one place of the points of each link, the nearest first.
    ///
    /// Input  short_edges: pairs of points, the ends of edges so short that the links could make
    ///        one place of both. They stay apart.
    void unite(std::vector<Link> links, const std::vector<std::pair<int, int>>& short_edges);

    /// Makes one place of two points.
    void unite(int a, int b);

    [[nodiscard]] int count() const { return static_cast<int>(points_.size()); }
    [[nodiscard]] const Eigen::Vector3d& point(int i) const { return points_[i]; }
    [[nodiscard]] const TopoDS_Vertex& vertex(int i) const { return vertices_[i]; }

    /// All pairs of points within the reach of each other.
    [[nodiscard]] std::vector<Link> near(double limit) const;

  private:
    std::vector<Eigen::Vector3d> points_;
    std::vector<TopoDS_Vertex> vertices_;
    std::vector<double> accuracies_;
    mutable std::vector<int> parent_;
};

}  // namespace suture

#pragma once

#include <Eigen/Core>

#include <TopoDS_Edge.hxx>

#include <vector>

namespace suture {

/// A closed run of edges by its length.
class LoopPoints {
  public:
    /// Input    edges: in walking order, oriented as they are walked.
    explicit LoopPoints(const std::vector<TopoDS_Edge>& edges);

    [[nodiscard]] double length() const { return starts_.empty() ? 0.0 : starts_.back(); }

    /// Where the edges start, as lengths from the first one's start.
    [[nodiscard]] std::vector<double> corners() const;

    /// `count` points at equal lengths from the one at `start` on, walked backwards if asked.
    [[nodiscard]] Eigen::Matrix3Xd points(double start, int count, bool backwards) const;

  private:
    struct Piece {
        TopoDS_Edge edge;
        std::vector<double> parameters, lengths;  ///< from the walk's start of the edge
    };
    std::vector<Piece> pieces_;
    std::vector<double> starts_;  ///< of the pieces, and the loop's length

    [[nodiscard]] Eigen::Vector3d at(double length) const;
};

}  // namespace suture

#pragma once

#include "suture/base/result.h"
#include "suture/detect/boundary_loop.h"

#include <Eigen/Core>

#include <TopoDS_Vertex.hxx>

#include <compare>
#include <cstddef>
#include <functional>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace suture {

/// One of the two ends of a chosen edge, as the edge stands in ChainEnds::sides.
struct ChainEnd {
    std::size_t side = 0;
    bool last = false;
    auto operator<=>(const ChainEnd&) const = default;
    [[nodiscard]] ChainEnd other() const { return {side, !last}; }
};

/// Which ends of chosen edges meet.
class ChainEnds {
  public:
    /// Whether an edge follows another one in the rim of its shell.
    using Follows = std::function<bool(std::size_t before, std::size_t after)>;

    ChainEnds() = default;

    /// Input  reach: ends up to this far apart meet, model units.
    ChainEnds(std::vector<BoundaryEdge> sides, double reach, Follows follows)
        : sides_(std::move(sides)), reach_(reach), follows_(std::move(follows)) {}

    /// Joins ends that touch; those of closed edges are each other's.
    ///
    /// Refuses  (Usage) more than two that meet in a point, unless they go on as rims do.
    [[nodiscard]] Result<void> join();

    [[nodiscard]] const std::vector<BoundaryEdge>& sides() const { return sides_; }
    /// Those that meet no other.
    [[nodiscard]] const std::vector<ChainEnd>& loose() const { return loose_; }
    /// That which an end meets; it must not be loose.
    [[nodiscard]] const ChainEnd& mate_of(const ChainEnd& end) const { return mates_.at(end); }

    [[nodiscard]] TopoDS_Vertex vertex(const ChainEnd& end) const;
    [[nodiscard]] Eigen::Vector3d point(const ChainEnd& end) const;
    /// "(1, 2, 3)"
    [[nodiscard]] std::string place_of(const ChainEnd& end) const;
    /// The other end of the open chain that ends here.
    [[nodiscard]] ChainEnd far_end(ChainEnd end) const;
    /// The two loose ends of different chains whose connection leaves the least to bridge; of one
    /// chain its own ends.
    [[nodiscard]] std::pair<ChainEnd, ChainEnd> nearest_ends() const;
    /// Marks all edges of a chain from one of its ends on, of a closed one from anywhere.
    ///
    /// Result  whether any was new.
    bool mark(ChainEnd end, std::set<std::size_t>& seen) const;

    /// Joins two loose ends by a curve that runs from the first one to the second.
    void connect(const ChainEnd& a, const ChainEnd& b, const BoundaryEdge& curve);

  private:
    [[nodiscard]] bool touch(const ChainEnd& a, const ChainEnd& b) const;
    Result<void> join_group(std::vector<ChainEnd> group);
    /// Where loops touch in a point, each goes on as the shell's own rim does.
    void follow_rims(std::vector<ChainEnd>& group);
    void mate(const ChainEnd& a, const ChainEnd& b);

    std::vector<BoundaryEdge> sides_;
    double reach_ = 0.0;
    Follows follows_;
    std::map<ChainEnd, ChainEnd> mates_;
    std::vector<ChainEnd> loose_;
};

}  // namespace suture

#pragma once

#include "suture/detect/shell_graph.h"
#include "suture/sew/free_edges.h"
#include "suture/sew/places.h"

#include <vector>

namespace suture {

/// Inner points of a piece at which it must meet the other.
inline constexpr int kSewProbes = 9;

/// A part of a free edge between two of its places.
struct SewPiece {
    int edge = 0;  ///< index of the free edge
    double first = 0.0;
    double last = 0.0;
    int start = 0;  ///< points of Places
    int end = 0;
};

/// Two pieces that become one edge, along the curve of the first.
struct SewPair {
    SewPiece kept;
    SewPiece gone;
    bool same_way = false;  ///< both curves run the same way
    double gap = 0.0;       ///< largest distance of nine inner points of one from the other
};

/// How far apart edges may lie that are sewn.
struct SewLimits {
    double tolerance = 0.0;  ///< model units
    /// Below it two faces that leave an edge to the same side are sewn as well; above they are the
    /// two sides of a thin wall.
    double wall = 0.0;
};

/// Finds which free edges belong together.
///
/// A free edge meets another one, a part of it, or a row of others, within the tolerance all along.
/// Where more than two meet, those of one shell come first, then those of one compound, then the
/// straightest. Edges too short for the tolerance keep two ends, unless one of them lets the edges
/// beside it meet: then it becomes a point. A hole smaller than the file's own accuracy is closed:
/// its long edges are sewn, the others become points.
class SewMatcher {
  public:
    /// Input  places: holds the ends of the edges; what is found to be one place becomes one.
    SewMatcher(const ShellGraph& graph, const std::vector<FreeEdge>& edges, Places& places);

    /// Whole edges whose ends lie within the tolerance of each other: most of them, at little cost.
    void match_whole(const SewLimits& limits);

    /// The rest: edges are cut where others end. Edges that the file itself is no better for may
    /// lie farther apart than the tolerance.
    void match_parts(const SewLimits& limits);

    [[nodiscard]] const std::vector<SewPair>& pairs() const { return pairs_; }
    [[nodiscard]] const std::vector<int>& collapsed() const { return collapsed_; }

    /// Free edges that meet no other, as uses of the graph.
    [[nodiscard]] std::vector<int> unmatched_uses() const;

  private:
    struct Cut {
        double parameter = 0.0;
        int point = 0;
    };
    struct Candidate;

    [[nodiscard]] double limit_of(int a, int b, const SewLimits& limits) const;
    [[nodiscard]] double fraction(const FreeEdge& edge, double parameter) const;
    [[nodiscard]] bool leave_to_one_side(int a, double at_a, int b, double at_b,
                                         double* cosine) const;
    [[nodiscard]] double gap_between(const SewPiece& a, const SewPiece& b, bool same_way,
                                     double limit) const;
    [[nodiscard]] bool is_slit(const SewPiece& a, const SewPiece& b, bool same_way) const;
    [[nodiscard]] bool bound_two_solids(const FreeEdge& a, const FreeEdge& b) const;
    [[nodiscard]] std::vector<std::pair<int, int>> short_edges(double limit) const;
    [[nodiscard]] std::vector<SewPiece> pieces() const;
    void find_cuts(const SewLimits& limits, std::vector<Places::Link>& links);
    void match(const std::vector<SewPiece>& pieces, const SewLimits& limits);
    bool collapse_short(const SewLimits& limits);
    void collapse_specks(const SewLimits& limits);
    void collapse(int edge);

    const ShellGraph& graph_;
    const std::vector<FreeEdge>& edges_;
    Places& places_;
    std::vector<std::vector<Cut>> cuts_;  // per edge, by parameter
    std::vector<bool> matched_;           // per edge: all of it
    std::vector<SewPair> pairs_;
    std::vector<int> collapsed_;
    bool by_accuracy_ = false;  // edges may lie as far apart as the file is good for
};

}  // namespace suture

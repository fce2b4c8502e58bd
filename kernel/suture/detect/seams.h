#pragma once

#include "suture/detect/shell_graph.h"

#include <Eigen/Core>

#include <TopoDS_Edge.hxx>

#include <vector>

namespace suture {

/// What lies on a free edge, all along it.
struct EdgePartner {
    double gap = 0.0;      ///< largest distance to free edges of other faces; huge: there are none
    double own_gap = 0.0;  ///< largest distance to the next free edge of the same face
    double length = 0.0;
    int partner = -1;     ///< the use that is nearest to the edge's middle within `gap`
    bool folded = false;  ///< the two faces leave the edge to the same side: a thin wall
};

/// The gap that still counts as a seam, as a share of the edge's length. Of the unsewn models the
/// widest real gap is 6e-4 (ANC101), the narrowest open edge 1e-2 (777-200LR) (docs/holes.md).
inline constexpr double kSeamShare = 2e-3;

/// The same between two edges of one face, or where both faces leave to the same side: there a
/// narrow slot or a thin wall is likelier than an open seam.
inline constexpr double kTightSeamShare = 1e-5;

/// Two faces leave a common edge to the same side when the angle between them is below 60 degrees.
inline constexpr double kSameSide = 0.5;

/// The unit direction away from the face, at right angles to the use.
///
/// Input  t in [0,1] along the use.
[[nodiscard]] Eigen::Vector3d onward(const ShellGraph& graph, int use, double t);

/// Input  uses: free edge uses, among which partners are looked for.
/// Result per element of `uses`.
[[nodiscard]] std::vector<EdgePartner> find_partners(const ShellGraph& graph,
                                                     const std::vector<int>& uses);

/// The edge lies on an edge of another face and should be sewn to it.
[[nodiscard]] inline bool is_seam(const EdgePartner& edge) {
    return edge.gap <= (edge.folded ? kTightSeamShare : kSeamShare) * edge.length;
}

/// The edge lies on another edge of its own face.
[[nodiscard]] inline bool is_fold(const EdgePartner& edge) {
    return edge.own_gap <= kTightSeamShare * edge.length;
}

}  // namespace suture

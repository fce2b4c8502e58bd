#pragma once

#include "suture/detect/shell_graph.h"
#include "suture/sew/free_edges.h"
#include "suture/sew/match.h"
#include "suture/sew/places.h"

#include <TopoDS_Face.hxx>

#include <vector>

namespace suture {

/// The faces of a shape with common edges where they were sewn.
struct RebuiltFaces {
    std::vector<TopoDS_Face>
        faces;                 ///< in the graph's order; those without a new edge are the same
    std::vector<bool> sewn;    ///< per face: it has a new neighbour
    int pairs = 0;             ///< of edges that have become one
    int points = 0;            ///< edges that have become points
    double largest_gap = 0.0;  ///< of these
};

/// Makes one vertex of each place, one edge of each pair, and the faces anew that use them. A pair
/// that would use one surface twice the same way is left out.
[[nodiscard]] RebuiltFaces rebuild_faces(const ShellGraph& graph,
                                         const std::vector<FreeEdge>& edges, const Places& places,
                                         const SewMatcher& matches);

}  // namespace suture

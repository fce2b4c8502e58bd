#pragma once

#include "suture/occ/topology.h"

#include <TopoDS_Edge.hxx>

#include <vector>

namespace suture {

/// One occurrence of an edge in the border of a face.
struct EdgeInFace {
    int face = 0;      ///< FaceN, 1-based
    TopoDS_Edge edge;  ///< oriented as in the face taken FORWARD: the face lies to its left
};

/// The uses of every edge of a shape (index EdgeN - 1), or only of the wanted ones (1-based; empty:
/// all). Degenerated edges and INTERNAL or EXTERNAL occurrences, which bound nothing, are left out.
[[nodiscard]] std::vector<std::vector<EdgeInFace>> find_edge_uses(const occ::Numbering& numbering,
                                                                  const std::vector<int>& wanted);

}  // namespace suture

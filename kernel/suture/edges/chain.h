#pragma once

#include "suture/base/result.h"
#include "suture/detect/boundary_loop.h"
#include "suture/occ/topology.h"

#include <TopoDS_Shape.hxx>

#include <map>
#include <vector>

namespace suture {

/// The edges that are to bound one new face, as a user names them: in any order and direction.
struct ChosenBoundary {
    std::vector<int> edges;            ///< EdgeN
    double reach = 0.0;                ///< ends up to this far apart are one corner, model units
    bool connect = false;              ///< wider gaps are bridged by curves
    bool two_sides = false;            ///< the edges have to form two chains, or two closed loops
    std::map<int, int> supports = {};  ///< EdgeN -> FaceN that it lies on
    double tension = 1.0;  ///< length of the curves' end tangents, as a multiple of the gap
};

/// Chains chosen edges to closed loops. An edge that one face uses is walked against its use, as in
/// find_loops; where a sheet faces the other way than the first one, its face is turned over. Edges
/// without a face have none in the loop either.
///
/// Input    rims: all boundary loops of the shape, as find_loops gives them.
/// Result   the loops of one face, the longest first; one that is a rim as a whole has its id,
///          another one an id behind all of the rims. A curve that closes a gap has no edge number.
/// Refuses  (Usage) an edge that does not exist, is named twice, has no length or lies between two
///          faces; edges that form no closed chain: which ones, and how far it is to the next end;
///          supports as lean_on_supports refuses them.
[[nodiscard]] Result<std::vector<BoundaryLoop>> chain_edges(const TopoDS_Shape& shape,
                                                            const occ::Numbering& numbering,
                                                            const std::vector<BoundaryLoop>& rims,
                                                            const ChosenBoundary& chosen);

}  // namespace suture

#pragma once

#include "suture/detect/boundary_loop.h"
#include "suture/fill/fill.h"
#include "suture/model/ribbon.h"
#include "suture/occ/topology.h"

#include <TopoDS_Face.hxx>

#include <vector>

namespace suture {

/// The surfaces of faces whose outline is congruent to the hole's, moved or mirrored onto it:
/// "mirrored twin of face 31". Outlines may be divided into other edges as long as they share a
/// corner.
///
/// Source   Umeyama, Least-squares estimation of transformation parameters between two point
///          patterns, IEEE PAMI 13 (1991).
[[nodiscard]] std::vector<Candidate> find_twins(const std::vector<TopoDS_Face>& faces,
                                                const occ::Numbering& numbering,
                                                const std::vector<BoundaryLoop>& loops,
                                                const Hole& hole);

}  // namespace suture

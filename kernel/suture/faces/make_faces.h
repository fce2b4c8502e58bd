#pragma once

#include "suture/base/result.h"
#include "suture/detect/boundary_loop.h"
#include "suture/model/patch.h"
#include "suture/model/ribbon.h"

#include <TopoDS_Face.hxx>

#include <vector>

namespace suture {

/// New faces for a hole, built on the hole's own edges and vertices: the edges get a further
/// pcurve, and a larger tolerance where they miss the new surface by more than theirs; nothing else
/// of them changes.
struct NewFaces {
    std::vector<TopoDS_Face> faces;  ///< oriented outwards
    double max_gap = 0.0;            ///< largest distance edge to new surface, model units
    int grown_edges = 0;             ///< edges that needed a larger tolerance for that
    double grown_tolerance = 0.0;    ///< the largest of these tolerances
};

/// Input    loops: the hole's, in the order of hole.loops; result: what a fill method made of them.
/// Refuses  a patch whose surface or trimming curves OCCT cannot take.
[[nodiscard]] Result<NewFaces> make_faces(const std::vector<BoundaryLoop>& loops, const Hole& hole,
                                          const FillResult& result);

}  // namespace suture

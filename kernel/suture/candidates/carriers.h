#pragma once

#include "suture/fill/fill.h"
#include "suture/model/ribbon.h"
#include "suture/occ/topology.h"

#include <TopoDS_Face.hxx>

#include <vector>

namespace suture {

/// Surfaces of faces that carry the whole border of a hole, or that have it at one distance all
/// along: "the surface of face 4", "face 4, offset by 2".
///
/// Input    faces: the neighbours first; noise: of the model's edges here, in model units.
[[nodiscard]] std::vector<Candidate> find_carriers(const std::vector<TopoDS_Face>& faces,
                                                   const occ::Numbering& numbering,
                                                   const Hole& hole, double noise, bool offsets);

}  // namespace suture

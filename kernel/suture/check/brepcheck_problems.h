#pragma once

#include "suture/occ/topology.h"

#include <string>
#include <vector>

namespace suture {

/// What BRepCheck finds wrong, in words: "Edge7 on Face3: curve on the surface is off the edge".
/// Each problem once, by kind of shape and number; empty for a valid shape.
[[nodiscard]] std::vector<std::string> find_brepcheck_problems(const TopoDS_Shape& shape,
                                                               const occ::Numbering& numbering);

}  // namespace suture

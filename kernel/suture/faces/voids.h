#pragma once

#include <TopoDS_Shape.hxx>

#include <vector>

namespace suture {

/// Closed shells that face inwards and lie in a solid beside them are voids of that solid, whose
/// boundary a reader had to leave open: the solid takes them in. Everything else stays.
///
/// Input    shapes: of one compound.
/// Result   the shapes without those shells, solids with voids in the places of the old ones.
[[nodiscard]] std::vector<TopoDS_Shape> take_in_voids(std::vector<TopoDS_Shape> shapes);

}  // namespace suture

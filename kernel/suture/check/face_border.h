#pragma once

#include "suture/check/surface_tree.h"

#include <TopoDS_Face.hxx>

namespace suture {

/// Twice the area over the length of the border, roughly: of a strip its width, of a disc its
/// radius.
[[nodiscard]] double width_of(const TopoDS_Face& face, const SurfaceTree& tree);

/// The surface at the pcurves runs along the edges, on most of their length, not against them.
[[nodiscard]] bool runs_along_edges(const TopoDS_Face& face, const SurfaceTree& tree);

}  // namespace suture

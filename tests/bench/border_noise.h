#pragma once

#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>

namespace suture::bench {

/// Largest distance of an edge's own curve from the surface of a face that it bounds.
[[nodiscard]] double noise_of(const TopoDS_Edge& edge, const TopoDS_Face& face);

/// How exact a file is around a face that was taken out of it: the largest distance of the hole's
/// edges from the lost face's surface and from those of its neighbours.
///
/// Input    open: the model without that face.
[[nodiscard]] double border_noise(const TopoDS_Shape& open, const TopoDS_Face& lost);

}  // namespace suture::bench

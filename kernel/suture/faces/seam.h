#pragma once

#include "suture/model/patch.h"
#include "suture/occ/handle.h"

#include <Eigen/Core>

#include <Geom_Surface.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Vertex.hxx>

namespace suture {

/// A seam from one vertex to another, as an edge with a pcurve for each of its two uses.
///
/// Input    start, end: the vertices at seam.from and seam.to, whose tolerances grow where the
///          surface misses them; reversed: the wire will be turned over (Patch::reversed);
///          accuracy: of the 3D curve where the seam is no line of constant u or v, model units.
/// Result   oriented from start to end.
[[nodiscard]] TopoDS_Edge make_seam(const Seam& seam, const occ::Handle<Geom_Surface>& surface,
                                    const TopoDS_Vertex& start, const TopoDS_Vertex& end,
                                    bool reversed, double accuracy);

/// The border of the domain from `from` to `to` where it is one point, as an edge without a curve.
[[nodiscard]] TopoDS_Edge make_degenerated(const Eigen::Vector2d& from, const Eigen::Vector2d& to,
                                           const occ::Handle<Geom_Surface>& surface,
                                           const TopoDS_Vertex& vertex);

}  // namespace suture

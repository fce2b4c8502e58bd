#pragma once

#include "suture/occ/handle.h"

#include <Eigen/Core>

#include <Geom_Surface.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Vertex.hxx>

namespace suture {

/// The border of the domain from `from` to `to` where it is one point, as an edge without a curve.
[[nodiscard]] TopoDS_Edge make_pole_edge(const Eigen::Vector2d& from, const Eigen::Vector2d& to,
                                         const occ::Handle<Geom_Surface>& surface,
                                         const TopoDS_Vertex& vertex);

}  // namespace suture

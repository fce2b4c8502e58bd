#pragma once

#include "suture/detect/boundary_loop.h"
#include "suture/faces/put_on_surface.h"
#include "suture/model/patch.h"

#include <TopoDS_Edge.hxx>
#include <TopoDS_Vertex.hxx>

#include <vector>

namespace suture {

/// The edges and vertices that a fill adds between its patches, made as the patches use them.
class InnerEdges {
  public:
    /// accuracy: of a new edge's curve on the surface that it is made from, model units.
    InnerEdges(const std::vector<BoundaryLoop>& loops, const FillResult& result, double accuracy);

    /// An inner edge from its start to its end. The first patch to ask gives it its curve.
    [[nodiscard]] const TopoDS_Edge& edge(const EdgeUse& use,
                                          const occ::Handle<Geom_Surface>& surface);

  private:
    [[nodiscard]] TopoDS_Vertex vertex(const Node& node) const;

    const std::vector<BoundaryLoop>& loops_;
    const FillResult& result_;
    double accuracy_;
    std::vector<TopoDS_Vertex> vertices_;
    std::vector<TopoDS_Edge> edges_;
};

}  // namespace suture

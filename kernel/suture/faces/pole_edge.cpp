#include "suture/faces/pole_edge.h"

#include "suture/occ/convert.h"

#include <BRep_Builder.hxx>
#include <Geom2d_Line.hxx>
#include <Precision.hxx>

namespace suture {

TopoDS_Edge make_pole_edge(const Eigen::Vector2d& from, const Eigen::Vector2d& to,
                           const occ::Handle<Geom_Surface>& surface, const TopoDS_Vertex& vertex) {
    const Eigen::Vector2d way = to - from;
    const BRep_Builder builder;
    TopoDS_Edge edge;
    builder.MakeEdge(edge);
    builder.UpdateEdge(edge,
                       occ::make<Geom2d_Line>(occ::to_point(from), gp_Dir2d(way.x(), way.y())),
                       surface, TopLoc_Location(), Precision::Confusion());
    builder.Add(edge, vertex.Oriented(TopAbs_FORWARD));
    builder.Add(edge, vertex.Oriented(TopAbs_REVERSED));
    builder.Range(edge, 0.0, way.norm());
    builder.Degenerated(edge, Standard_True);
    return edge;
}

}  // namespace suture

#include "suture/faces/unite_corners.h"

#include "suture/occ/topology.h"

#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <TopExp.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Iterator.hxx>

#include <algorithm>

namespace suture {
namespace {

void replace(const TopoDS_Edge& edge, const TopoDS_Vertex& old, const TopoDS_Vertex& kept) {
    TopoDS_Shape changed = edge.Oriented(TopAbs_FORWARD);
    std::vector<TopoDS_Shape> ends;
    for (TopoDS_Iterator it(changed); it.More(); it.Next()) {
        if (it.Value().IsSame(old)) {
            ends.push_back(it.Value());
        }
    }
    const bool was_free = changed.Free();
    changed.Free(Standard_True);
    const BRep_Builder builder;
    for (const TopoDS_Shape& end : ends) {
        builder.Remove(changed, end);
        builder.Add(changed, kept.Oriented(end.Orientation()));
    }
    changed.Free(was_free);
}

void unite(const TopoDS_Shape& shape, const std::vector<BoundaryLoop>& loops,
           const TopoDS_Vertex& kept, const TopoDS_Vertex& old) {
    const double apart = BRep_Tool::Pnt(kept).Distance(BRep_Tool::Pnt(old));
    BRep_Builder().UpdateVertex(kept, apart + BRep_Tool::Tolerance(old));
    for (const TopoDS_Edge& edge : occ::edges_of(shape)) {
        replace(edge, old, kept);
    }
    for (const BoundaryLoop& loop : loops) {  // curves that are not in the shape
        for (const BoundaryEdge& side : loop.edges) {
            replace(side.edge, old, kept);
        }
    }
}

}  // namespace

void unite_corners(const TopoDS_Shape& shape, const std::vector<BoundaryLoop>& loops) {
    for (const BoundaryLoop& loop : loops) {
        for (std::size_t i = 0; i < loop.edges.size(); ++i) {
            const TopoDS_Edge& next = loop.edges[(i + 1) % loop.edges.size()].edge;
            const TopoDS_Vertex end = TopExp::LastVertex(loop.edges[i].edge, Standard_True);
            const TopoDS_Vertex start = TopExp::FirstVertex(next, Standard_True);
            if (end.IsNull() || start.IsNull() || end.IsSame(start)) {
                continue;
            }
            if (BRep_Tool::Pnt(end).Distance(BRep_Tool::Pnt(start)) <=
                std::max(
                    {BRep_Tool::Tolerance(end), BRep_Tool::Tolerance(start), loop.corner_reach})) {
                unite(shape, loops, start, end);
            }
        }
    }
}

}  // namespace suture

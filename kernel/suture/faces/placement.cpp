#include "suture/faces/placement.h"

#include <BRep_Tool.hxx>
#include <TopExp.hxx>

namespace suture {

Placement placement_of(const TopoDS_Edge& edge, const occ::Handle<Geom2d_Curve>& pcurve, double gap,
                       double reach) {
    Placement found{pcurve, gap, reach, {}, {}, {}};
    double first = 0.0;
    double last = 0.0;
    found.curve = BRep_Tool::Curve(edge, found.location, first, last);
    found.ends = {BRep_Tool::Pnt(TopExp::FirstVertex(edge)),
                  BRep_Tool::Pnt(TopExp::LastVertex(edge))};
    return found;
}

bool Placement::holds_for(const TopoDS_Edge& edge) const {
    const Placement other = placement_of(edge, {}, 0.0, 0.0);
    return other.curve == curve && other.location == location &&
           other.ends[0].IsEqual(ends[0], 0.0) && other.ends[1].IsEqual(ends[1], 0.0);
}

}  // namespace suture

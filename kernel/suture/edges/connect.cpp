#include "suture/edges/connect.h"

#include "suture/occ/convert.h"

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRep_Tool.hxx>
#include <Geom_BezierCurve.hxx>
#include <TColgp_Array1OfPnt.hxx>

namespace suture {

TopoDS_Edge connect_ends(const CurveEnd& from, const CurveEnd& to, double tension) {
    const Eigen::Vector3d a = occ::from_occ(BRep_Tool::Pnt(from.vertex));
    const Eigen::Vector3d b = occ::from_occ(BRep_Tool::Pnt(to.vertex));
    const double third = tension * (b - a).norm() / 3.0;
    TColgp_Array1OfPnt poles(1, 4);
    poles(1) = occ::to_point(a);
    poles(2) = occ::to_point(Eigen::Vector3d(a + third * from.leaving));
    poles(3) = occ::to_point(Eigen::Vector3d(b + third * to.leaving));
    poles(4) = occ::to_point(b);
    const occ::Handle<Geom_Curve> curve = occ::make<Geom_BezierCurve>(poles);
    return BRepBuilderAPI_MakeEdge(curve, from.vertex, to.vertex);
}

}  // namespace suture

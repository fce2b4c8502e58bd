#include "suture/edges/walk.h"

#include "suture/occ/convert.h"

#include <Eigen/Geometry>

#include <BRepAdaptor_Curve.hxx>
#include <GCPnts_AbscissaPoint.hxx>
#include <TopoDS.hxx>

namespace suture {
namespace {

using Eigen::Vector3d;

/// Points per edge for the size of a loop.
constexpr int kPoints = 64;

}  // namespace

std::pair<Vector3d, Vector3d> walk_to(const TopoDS_Edge& edge, double s) {
    const BRepAdaptor_Curve curve(edge);
    const bool backwards = edge.Orientation() == TopAbs_REVERSED;
    const double t = curve.FirstParameter() +
                     (backwards ? 1.0 - s : s) * (curve.LastParameter() - curve.FirstParameter());
    gp_Pnt point;
    gp_Vec along;
    curve.D1(t, point, along);
    return {occ::from_occ(point), (backwards ? -1.0 : 1.0) * occ::from_occ(along)};
}

Vector3d area_of(const BoundaryLoop& loop) {
    const Vector3d origin = walk_to(loop.edges.front().edge, 0.0).first;
    Vector3d area = Vector3d::Zero();
    for (const BoundaryEdge& side : loop.edges) {
        Vector3d before = walk_to(side.edge, 0.0).first - origin;
        for (int k = 1; k <= kPoints; ++k) {
            const Vector3d here =
                walk_to(side.edge, static_cast<double>(k) / kPoints).first - origin;
            area += before.cross(here);
            before = here;
        }
    }
    return area;
}

BoundaryEdge turned(BoundaryEdge side) {
    side.edge = TopoDS::Edge(side.edge.Reversed());
    if (!side.face.IsNull()) {
        side.face = TopoDS::Face(side.face.Reversed());
    }
    if (!side.support.IsNull()) {
        side.support = TopoDS::Face(side.support.Reversed());
    }
    return side;
}

void measure_size(BoundaryLoop& loop) {
    Eigen::AlignedBox3d box;
    loop.length = 0.0;
    for (const BoundaryEdge& side : loop.edges) {
        loop.length += GCPnts_AbscissaPoint::Length(BRepAdaptor_Curve(side.edge));
        for (int k = 0; k <= kPoints; ++k) {
            box.extend(walk_to(side.edge, static_cast<double>(k) / kPoints).first);
        }
    }
    loop.diameter = box.diagonal().norm();
}

}  // namespace suture

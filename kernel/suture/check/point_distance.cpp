#include "suture/check/point_distance.h"

#include "suture/base/tolerance.h"

#include <Eigen/Geometry>

#include <BRepBuilderAPI_MakeVertex.hxx>
#include <BRepExtrema_DistShapeShape.hxx>
#include <BRep_Tool.hxx>
#include <GeomAPI_ProjectPointOnSurf.hxx>
#include <Geom_Surface.hxx>

#include <cmath>
#include <limits>

namespace suture {
namespace {

/// The angle between a direction and a surface's normal next to a point; a right angle where the
/// surface has none.
double angle_at(const gp_Pnt& point, const TopoDS_Face& face, const Eigen::Vector3d& direction) {
    const auto surface = BRep_Tool::Surface(face);
    GeomAPI_ProjectPointOnSurf nearest(point, surface);
    if (nearest.NbPoints() == 0) {
        return kPi / 2.0;
    }
    double u = 0.0;
    double v = 0.0;
    nearest.LowerDistanceParameters(u, v);
    gp_Pnt foot;
    gp_Vec along_u;
    gp_Vec along_v;
    surface->D1(u, v, foot, along_u, along_v);
    const gp_Vec n = along_u.Crossed(along_v);
    const Eigen::Vector3d normal(n.X(), n.Y(), n.Z());
    return normal.norm() > 0.0
               ? std::atan2(normal.cross(direction).norm(), std::abs(normal.dot(direction)))
               : kPi / 2.0;
}

}  // namespace

PointMiss measure_miss(const ThroughPoint& wanted, std::span<const TopoDS_Face> faces) {
    const Eigen::Vector3d& p = wanted.point;
    const TopoDS_Shape vertex = BRepBuilderAPI_MakeVertex(gp_Pnt(p.x(), p.y(), p.z())).Shape();
    PointMiss miss;
    miss.distance = std::numeric_limits<double>::infinity();
    for (const TopoDS_Face& face : faces) {
        const BRepExtrema_DistShapeShape distance(vertex, face);
        if (distance.IsDone() && distance.Value() < miss.distance) {
            miss.distance = distance.Value();
            miss.angle =
                wanted.normal ? angle_at(distance.PointOnShape2(1), face, *wanted.normal) : 0.0;
        }
    }
    return miss;
}

}  // namespace suture

#include "suture/check/point_distance.h"

#include <BRepBuilderAPI_MakeVertex.hxx>
#include <BRepExtrema_DistShapeShape.hxx>

#include <algorithm>
#include <limits>

namespace suture {

double measure_distance(const Eigen::Vector3d& point, std::span<const TopoDS_Face> faces) {
    const TopoDS_Shape vertex =
        BRepBuilderAPI_MakeVertex(gp_Pnt(point.x(), point.y(), point.z())).Shape();
    double least = std::numeric_limits<double>::infinity();
    for (const TopoDS_Face& face : faces) {
        const BRepExtrema_DistShapeShape distance(vertex, face);
        if (distance.IsDone()) {
            least = std::min(least, distance.Value());
        }
    }
    return least;
}

}  // namespace suture

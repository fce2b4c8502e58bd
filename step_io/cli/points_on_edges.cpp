#include "cli/points_on_edges.h"

#include "suture/edges/supports.h"
#include "suture/occ/convert.h"
#include "suture/occ/guard.h"
#include "suture/occ/topology.h"

#include <BRepAdaptor_Curve.hxx>
#include <BRep_Tool.hxx>
#include <TopoDS.hxx>

#include <algorithm>

namespace suture::cli {
namespace {

constexpr int kPoints = 24;

Result<std::vector<ThroughPoint>> points_on_edge(const TopoDS_Edge& edge) {
    std::vector<ThroughPoint> points;
    const BRepAdaptor_Curve curve(edge);
    for (int k = 0; k <= kPoints; ++k) {
        const double t =
            curve.FirstParameter() + (curve.LastParameter() - curve.FirstParameter()) * k / kPoints;
        points.push_back({occ::from_occ(curve.Value(t))});
    }
    return points;
}

/// Takes the normals of a face's surface next to points.
///
/// Result  how far the farthest of the points is from the surface.
double take_normals(const TopoDS_Face& face, std::vector<ThroughPoint>& points) {
    const auto surface = BRep_Tool::Surface(face);
    double apart = 0.0;
    for (ThroughPoint& point : points) {
        const SurfaceFoot foot = foot_of(point.point, surface);
        apart = std::max(apart, foot.apart);
        point.normal = foot.normal;
    }
    return apart;
}

}  // namespace

Result<std::vector<ThroughPoint>> points_on_edges(const TopoDS_Shape& model,
                                                  const std::vector<std::pair<int, int>>& edges,
                                                  double reach) {
    const occ::Numbering numbering(model);
    std::vector<ThroughPoint> result;
    for (const auto& [number, face] : edges) {
        if (number > numbering.edges.Extent()) {
            return fail(ErrorCode::Usage, "there is no edge {}: the model has {} edges", number,
                        numbering.edges.Extent());
        }
        if (face > numbering.faces.Extent()) {
            return fail(ErrorCode::Usage, "there is no face {}: the model has {} faces", face,
                        numbering.faces.Extent());
        }
        const TopoDS_Edge edge = TopoDS::Edge(numbering.edges(number));
        if (BRep_Tool::Degenerated(edge)) {
            return fail(ErrorCode::Usage, "edge {} has no length: no face can follow it", number);
        }
        auto points = occ::guarded("following an edge", [&] { return points_on_edge(edge); });
        if (!points) {
            return points;
        }
        if (face > 0) {
            const TopoDS_Face& neighbour = TopoDS::Face(numbering.faces(face));
            const auto apart = occ::guarded("taking a face's normals",
                                            [&] { return take_normals(neighbour, *points); });
            if (!apart) {
                return tl::unexpected(apart.error());
            }
            if (*apart > reach) {
                return fail(ErrorCode::Usage,
                            "edge {} does not lie on face {}: it is {:.3g} away, more than {:.3g}",
                            number, face, *apart, reach);
            }
        }
        result.insert(result.end(), points->begin(), points->end());
    }
    return result;
}

}  // namespace suture::cli

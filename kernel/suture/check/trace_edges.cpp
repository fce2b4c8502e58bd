#include "suture/check/trace_edges.h"

#include "suture/check/edge_uses.h"
#include "suture/check/face_side.h"
#include "suture/check/measure_edge.h"
#include "suture/occ/guard.h"
#include "suture/occ/topology.h"

#include <tbb/parallel_for.h>

#include <BRepAdaptor_Curve.hxx>
#include <TopoDS.hxx>

#include <limits>

namespace suture {

namespace {

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

Eigen::Vector3d to_eigen(const gp_XYZ& p) {
    return {p.X(), p.Y(), p.Z()};
}

TracePoint point_at(const BRepAdaptor_Curve& curve, std::array<FaceSide, 2>& sides, double t,
                    double& speed) {
    gp_Pnt point;
    gp_Vec tangent;
    curve.D1(t, point, tangent);
    speed = tangent.Magnitude();
    const std::array<BorderPoint, 2> at = {sides[0].at(t, point, tangent),
                                           sides[1].at(t, point, tangent)};
    TracePoint result;
    result.point = to_eigen(point.XYZ());
    result.gap = at[0].point.Distance(at[1].point);
    result.angle = kUnknown;
    if (at[0].normal && at[1].normal) {
        result.angle =
            std::atan2(at[0].normal->CrossMagnitude(*at[1].normal), *at[0].normal * *at[1].normal);
    }
    for (const std::size_t i : {0U, 1U}) {
        result.curvature.at(i) = at.at(i).curvature.value_or(kUnknown);
        result.normal.at(i) = at.at(i).normal ? to_eigen(at.at(i).normal->XYZ())
                                              : Eigen::Vector3d::Constant(kUnknown);
    }
    return result;
}

std::vector<TracePoint> trace(const TopoDS_Edge& edge, const std::vector<EdgeInFace>& uses,
                              const occ::Numbering& numbering, int most) {
    const BRepAdaptor_Curve curve(edge);
    const EdgeRange range{curve.FirstParameter(), curve.LastParameter()};
    const double edge_length = length_of(edge, curve);
    const auto side = [&](std::size_t i) {
        return FaceSide(TopoDS::Face(numbering.faces(uses[i].face)), uses[i].edge, range,
                        edge_length);
    };
    std::array<FaceSide, 2> sides = {side(0), side(1)};
    const bool straight =
        curve.GetType() == GeomAbs_Line && sides[0].is_plane() && sides[1].is_plane();
    const int count = straight ? 2 : most;
    std::vector<TracePoint> points;
    double length = 0.0;
    double speed_before = 0.0;
    for (int i = 0; i < count; ++i) {
        const double step = (range.last - range.first) / (count - 1);
        double speed = 0.0;
        TracePoint point = point_at(curve, sides, range.first + i * step, speed);
        length += i > 0 ? 0.5 * (speed + speed_before) * step : 0.0;
        speed_before = speed;
        point.along = length;
        points.push_back(point);
    }
    for (TracePoint& point : points) {
        point.along = length > 0.0 ? point.along / length : 0.0;
    }
    return points;
}

}  // namespace

Result<std::vector<EdgeTrace>> trace_edges(const TopoDS_Shape& shape, const std::vector<int>& edges,
                                           int most, const Progress& progress) {
    std::vector<EdgeTrace> traces(edges.size());
    if (edges.empty()) {
        return traces;
    }
    const occ::Numbering numbering(shape);
    const auto all_uses = find_edge_uses(numbering, edges);
    tbb::parallel_for(std::size_t{0}, edges.size(), [&](std::size_t i) {
        traces[i].edge = edges[i];
        const auto& uses = all_uses.at(static_cast<std::size_t>(edges[i] - 1));
        if (progress.cancelled() || uses.size() != 2) {
            return;
        }
        auto points = occ::guarded("tracing an edge", [&] {
            return trace(TopoDS::Edge(numbering.edges(edges[i])), uses, numbering, most);
        });
        if (points) {
            traces[i].points = std::move(*points);
        }
    });
    if (progress.cancelled()) {
        return fail(ErrorCode::Cancelled, "tracing the edges was stopped");
    }
    return traces;
}

}  // namespace suture

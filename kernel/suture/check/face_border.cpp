#include "suture/check/face_border.h"

#include <BRepAdaptor_Curve.hxx>
#include <BRep_Tool.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>

#include <cmath>

namespace suture {

namespace {

constexpr int kGrid = 16;        // points in each direction of a face, for its area
constexpr int kEdgePoints = 24;  // and along each of its edges

Eigen::Vector3d to_eigen(const gp_Pnt& p) {
    return {p.X(), p.Y(), p.Z()};
}

}  // namespace

double width_of(const TopoDS_Face& face, const SurfaceTree& tree) {
    double area = 0.0;
    const ParameterBox& box = tree.cell(0).uv;
    for (int i = 0; i < kGrid; ++i) {
        for (int j = 0; j < kGrid; ++j) {
            const double u = box.low[0] + (i + 0.5) / kGrid * box.size(0);
            const double v = box.low[1] + (j + 0.5) / kGrid * box.size(1);
            if (tree.domain().contains(u, v)) {
                const SurfacePoint point = tree.at(u, v);
                area +=
                    point.du.cross(point.dv).norm() * box.size(0) * box.size(1) / (kGrid * kGrid);
            }
        }
    }
    double length = 0.0;
    for (TopExp_Explorer it(face, TopAbs_EDGE); it.More(); it.Next()) {
        const TopoDS_Edge& edge = TopoDS::Edge(it.Current());
        if (BRep_Tool::Degenerated(edge)) {
            continue;
        }
        const BRepAdaptor_Curve curve(edge);
        const double first = curve.FirstParameter();
        const double step = (curve.LastParameter() - first) / kEdgePoints;
        Eigen::Vector3d before = to_eigen(curve.Value(first));
        for (int k = 1; k <= kEdgePoints; ++k) {
            const Eigen::Vector3d now = to_eigen(curve.Value(first + k * step));
            length += (now - before).norm();
            before = now;
        }
    }
    return length > 0.0 ? 2.0 * area / length : std::sqrt(area);
}

bool runs_along_edges(const TopoDS_Face& face, const SurfaceTree& tree) {
    double with = 0.0;
    double against = 0.0;
    const TopoDS_Face forward = TopoDS::Face(face.Oriented(TopAbs_FORWARD));
    for (TopExp_Explorer it(forward, TopAbs_EDGE); it.More(); it.Next()) {
        const TopoDS_Edge& edge = TopoDS::Edge(it.Current());
        double first = 0.0;
        double last = 0.0;
        const auto pcurve = BRep_Tool::CurveOnSurface(edge, forward, first, last);
        if (BRep_Tool::Degenerated(edge) || pcurve.IsNull()) {
            continue;
        }
        const BRepAdaptor_Curve curve(edge);
        for (int k = 0; k < kEdgePoints; ++k) {
            const auto point = [&](double s) {
                const gp_Pnt2d uv = pcurve->Value(first + s * (last - first));
                const auto in = tree.clamped({uv.X(), uv.Y()});
                return tree.point(in[0], in[1]);
            };
            const auto on_edge = [&](double s) {
                const double from = curve.FirstParameter();
                return to_eigen(curve.Value(from + s * (curve.LastParameter() - from)));
            };
            const double s = static_cast<double>(k) / kEdgePoints;
            const double next = static_cast<double>(k + 1) / kEdgePoints;
            const Eigen::Vector3d chord = on_edge(next) - on_edge(s);
            const double along = chord.dot(point(next) - point(s));
            (along >= 0.0 ? with : against) += chord.norm();
        }
    }
    return with >= against;
}

}  // namespace suture

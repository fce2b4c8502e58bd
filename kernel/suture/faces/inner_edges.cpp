#include "suture/faces/inner_edges.h"

#include "suture/base/contract.h"
#include "suture/faces/pcurve.h"
#include "suture/occ/convert.h"

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepLib.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <BSplCLib.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_TrimmedCurve.hxx>
#include <Precision.hxx>
#include <Standard_Failure.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TopExp.hxx>
#include <TopoDS.hxx>

#include <algorithm>
#include <cmath>

namespace suture {
namespace {

using Eigen::Vector2d;
using occ::Handle;

/// Below OCCT's smallest tolerance a curve need not be fitted better than by this share of it.
constexpr double kFitShare = 1e-3;

/// How far from a line of constant u or v a trim may run and still be that line: rounding only.
constexpr double kStraight = 1e-13;

/// Whether a trim runs evenly along a line of constant u or v.
bool is_isoline(const TrimCurve& at) {
    const Vector2d a = at(0.0);
    const Vector2d b = at(1.0);
    const double size = std::max(a.cwiseAbs().maxCoeff(), b.cwiseAbs().maxCoeff());
    if ((b - a).cwiseAbs().minCoeff() > kStraight * size) {
        return false;
    }
    constexpr int kProbes = 7;
    for (int k = 1; k < kProbes; ++k) {
        const double s = static_cast<double>(k) / kProbes;
        if ((at(s) - a - s * (b - a)).cwiseAbs().maxCoeff() > kStraight * size) {
            return false;
        }
    }
    return true;
}

/// A curve in space from its start to its end.
struct Course {
    Handle<Geom_Curve> curve;
    double first = 0.0, last = 1.0;
};

/// A B-spline's own curve along an isoline, on [0, 1].
Course isoline(const Handle<Geom_BSplineCurve>& curve, const Vector2d& a, const Vector2d& b,
               int along) {
    curve->Segment(std::min(a[along], b[along]), std::max(a[along], b[along]));
    if (b[along] < a[along]) {
        curve->Reverse();
    }
    TColStd_Array1OfReal knots(1, curve->NbKnots());
    curve->Knots(knots);
    BSplCLib::Reparametrize(0.0, 1.0, knots);
    curve->SetKnots(knots);
    return {curve, 0.0, 1.0};
}

/// The surface's own curve along an isoline; the line, circle or the like of a closed form has its
/// own parameter.
Course isoline(const Geom_Surface& surface, const Vector2d& a, const Vector2d& b) {
    const int along = std::abs(b.y() - a.y()) > std::abs(b.x() - a.x()) ? 1 : 0;
    Handle<Geom_Curve> curve = along == 1 ? surface.UIso(a.x()) : surface.VIso(a.y());
    if (const auto trimmed = occ::cast<Geom_TrimmedCurve>(curve)) {
        curve = trimmed->BasisCurve();
    }
    if (const auto spline = occ::cast<Geom_BSplineCurve>(curve)) {
        return isoline(spline, a, b, along);
    }
    if (a[along] < b[along]) {
        return {curve, a[along], b[along]};
    }
    return {curve->Reversed(), curve->ReversedParameter(a[along]),
            curve->ReversedParameter(b[along])};
}

/// The image of a trim, on [0, 1].
Course image(const TrimCurve& at, const Handle<Geom_Surface>& surface, double accuracy) {
    const TopoDS_Edge edge =
        BRepBuilderAPI_MakeEdge(fit_pcurve(at, 0.0, 1.0, *surface, accuracy), surface, 0.0, 1.0);
    constexpr int kDegree = 14;
    constexpr int kSpans = 1000;
    if (!BRepLib::BuildCurve3d(edge, std::max(accuracy, kFitShare * Precision::Confusion()),
                               GeomAbs_C2, kDegree, kSpans)) {
        throw Standard_Failure("an inner edge has no curve in space");
    }
    Course course;
    course.curve = BRep_Tool::Curve(edge, course.first, course.last);
    return course;
}

}  // namespace

InnerEdges::InnerEdges(const std::vector<BoundaryLoop>& loops, const FillResult& result,
                       double accuracy)
    : loops_(loops), result_(result), accuracy_(accuracy), edges_(result.inner_edges.size()) {
    for (const Eigen::Vector3d& point : result.inner_vertices) {
        TopoDS_Vertex& made = vertices_.emplace_back();
        BRep_Builder().MakeVertex(made, occ::to_point(point), Precision::Confusion());
    }
}

const TopoDS_Edge& InnerEdges::edge(const EdgeUse& use, const Handle<Geom_Surface>& surface) {
    SUTURE_EXPECTS(use.loop < 0);
    TopoDS_Edge& edge = edges_.at(static_cast<std::size_t>(use.index));
    if (!edge.IsNull()) {
        return edge;
    }
    const Course course = is_isoline(use.at) ? isoline(*surface, use.at(0.0), use.at(1.0))
                                             : image(use.at, surface, accuracy_);
    const InnerEdge& ends = result_.inner_edges[static_cast<std::size_t>(use.index)];
    const TopoDS_Vertex start = vertex(ends.from);
    const TopoDS_Vertex end = vertex(ends.to);
    reach(start, course.curve->Value(course.first));
    reach(end, course.curve->Value(course.last));
    const BRep_Builder builder;
    builder.MakeEdge(edge, course.curve, Precision::Confusion());
    builder.Add(edge, start.Oriented(TopAbs_FORWARD));
    builder.Add(edge, end.Oriented(TopAbs_REVERSED));
    builder.Range(edge, course.first, course.last);
    return edge;
}

TopoDS_Vertex InnerEdges::vertex(const Node& node) const {
    const auto index = static_cast<std::size_t>(node.index);
    if (node.loop < 0) {
        return vertices_.at(index);
    }
    return TopExp::FirstVertex(loops_.at(static_cast<std::size_t>(node.loop)).edges.at(index).edge,
                               /*CumOri=*/Standard_True);
}

}  // namespace suture

#include "suture/faces/seam.h"

#include "suture/faces/put_on_surface.h"
#include "suture/occ/convert.h"

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepLib.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Geom2d_Line.hxx>
#include <Geom_Curve.hxx>
#include <Geom_TrimmedCurve.hxx>
#include <Precision.hxx>
#include <TopoDS.hxx>

#include <algorithm>

namespace suture {
namespace {

using Eigen::Vector2d;
using occ::Handle;

/// Below OCCT's smallest tolerance a curve need not be fitted better than by this share of it.
constexpr double kFitShare = 1e-3;

Handle<Geom2d_Line> line(const Vector2d& through, const Vector2d& direction) {
    return occ::make<Geom2d_Line>(occ::to_point(through), gp_Dir2d(direction.x(), direction.y()));
}

/// The seam's curve with the parameters of its ends; pcurves run through from + t direction.
struct Course {
    Handle<Geom_Curve> curve;
    Vector2d origin, direction;  ///< of the pcurve: parameter t lies at origin + t direction
    double first = 0.0;          ///< at seam.from
    double last = 0.0;           ///< at seam.to
};

/// A line of constant u or v: an exact curve of the surface, by its own parameter.
Course straight(const Seam& seam, const Geom_Surface& surface, int along) {
    Course course;
    course.curve = along == 1 ? surface.UIso(seam.from.x()) : surface.VIso(seam.from.y());
    if (const auto trimmed = occ::cast<Geom_TrimmedCurve>(course.curve)) {
        course.curve = trimmed->BasisCurve();
    }
    course.direction = Vector2d::Unit(along);
    course.origin = seam.from;
    course.origin[along] = 0.0;
    course.first = seam.from[along];
    course.last = seam.to[along];
    return course;
}

Course slanting(const Seam& seam, const Handle<Geom_Surface>& surface, double accuracy) {
    Course course;
    course.origin = seam.from;
    course.last = (seam.to - seam.from).norm();
    course.direction = (seam.to - seam.from) / course.last;
    const TopoDS_Edge edge =
        BRepBuilderAPI_MakeEdge(line(course.origin, course.direction), surface, 0.0, course.last);
    constexpr int kDegree = 14;
    constexpr int kSpans = 1000;
    BRepLib::BuildCurve3d(edge, std::max(accuracy, kFitShare * Precision::Confusion()), GeomAbs_C2,
                          kDegree, kSpans);
    double first = 0.0;
    double last = 0.0;
    course.curve = BRep_Tool::Curve(edge, first, last);
    return course;
}

}  // namespace

TopoDS_Edge make_seam(const Seam& seam, const Handle<Geom_Surface>& surface,
                      const TopoDS_Vertex& start, const TopoDS_Vertex& end, bool reversed,
                      double accuracy) {
    const int along = seam.period.x() != 0.0 ? 1 : 0;
    const Course course = seam.from[1 - along] == seam.to[1 - along]
                              ? straight(seam, *surface, along)
                              : slanting(seam, surface, accuracy);
    reach(start, course.curve->Value(course.first));
    reach(end, course.curve->Value(course.last));
    const bool forward = course.first < course.last;
    const BRep_Builder builder;
    TopoDS_Edge edge;
    builder.MakeEdge(edge, course.curve, Precision::Confusion());
    builder.Add(edge, (forward ? start : end).Oriented(TopAbs_FORWARD));
    builder.Add(edge, (forward ? end : start).Oriented(TopAbs_REVERSED));
    // The use from start to end lies one period on; turning the wire over turns the uses over.
    const auto here = line(course.origin, course.direction);
    const auto there = line(course.origin + seam.period, course.direction);
    const bool forward_is_there = forward != reversed;
    builder.UpdateEdge(edge, forward_is_there ? there : here, forward_is_there ? here : there,
                       surface, TopLoc_Location(), Precision::Confusion());
    builder.Continuity(edge, surface, surface, TopLoc_Location(), TopLoc_Location(), GeomAbs_CN);
    builder.Range(edge, std::min(course.first, course.last), std::max(course.first, course.last));
    return TopoDS::Edge(edge.Oriented(forward ? TopAbs_FORWARD : TopAbs_REVERSED));
}

TopoDS_Edge make_degenerated(const Vector2d& from, const Vector2d& to,
                             const Handle<Geom_Surface>& surface, const TopoDS_Vertex& vertex) {
    const BRep_Builder builder;
    TopoDS_Edge edge;
    builder.MakeEdge(edge);
    builder.UpdateEdge(edge, line(from, to - from), surface, TopLoc_Location(),
                       Precision::Confusion());
    builder.Add(edge, vertex.Oriented(TopAbs_FORWARD));
    builder.Add(edge, vertex.Oriented(TopAbs_REVERSED));
    builder.Range(edge, 0.0, (to - from).norm());
    builder.Degenerated(edge, Standard_True);
    return edge;
}

}  // namespace suture

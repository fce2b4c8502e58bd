#include "files/check_numbers.h"

#include "suture/occ/guard.h"
#include "suture/occ/handle.h"

#include <fmt/format.h>

#include <BRep_CurveRepresentation.hxx>
#include <BRep_GCurve.hxx>
#include <BRep_ListIteratorOfListOfCurveRepresentation.hxx>
#include <BRep_TEdge.hxx>
#include <BRep_Tool.hxx>
#include <Geom2d_Curve.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_BezierSurface.hxx>
#include <Geom_Curve.hxx>
#include <Geom_Surface.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopTools_MapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Iterator.hxx>

#include <cmath>
#include <string>
#include <vector>

namespace suture::io {
namespace {

/// Millimetres: a thousand times around the earth is 4e13. Beyond, doubles are coarser than any
/// tolerance.
constexpr double kFarthest = 1e13;

/// OCCT's own infinity is 2e100; it stands in ranges that have no end.
constexpr double kEndless = 1e100;

bool is_near(const gp_XYZ& p) {
    return std::abs(p.X()) <= kFarthest && std::abs(p.Y()) <= kFarthest &&
           std::abs(p.Z()) <= kFarthest;  // false for what is no number
}

/// What is wrong, or nothing.
std::string fault_of_vertex(const TopoDS_Vertex& vertex) {
    const gp_Pnt point = BRep_Tool::Pnt(vertex);
    if (!is_near(point.XYZ())) {
        return fmt::format("lies at ({:.3g}, {:.3g}, {:.3g})", point.X(), point.Y(), point.Z());
    }
    const double tolerance = BRep_Tool::Tolerance(vertex);
    return tolerance <= kFarthest ? "" : fmt::format("has the tolerance {:.3g}", tolerance);
}

template <class Surface>
bool has_near_poles(const occ::Handle<Surface>& surface) {
    for (int i = 1; i <= surface->NbUPoles(); ++i) {
        for (int j = 1; j <= surface->NbVPoles(); ++j) {
            if (!is_near(surface->Pole(i, j).XYZ()) || !std::isfinite(surface->Weight(i, j))) {
                return false;
            }
        }
    }
    return true;
}

std::string fault_of_face(const TopoDS_Face& face) {
    const occ::Handle<Geom_Surface> surface = BRep_Tool::Surface(face);
    if (!(BRep_Tool::Tolerance(face) <= kFarthest)) {
        return fmt::format("has the tolerance {:.3g}", BRep_Tool::Tolerance(face));
    }
    const auto spline = occ::cast<Geom_BSplineSurface>(surface);
    const auto bezier = occ::cast<Geom_BezierSurface>(surface);
    const bool near =
        (spline.IsNull() || has_near_poles(spline)) && (bezier.IsNull() || has_near_poles(bezier));
    return near ? "" : "has a control point that is no point";
}

std::string fault_of_point(const char* what, const gp_XYZ& p) {
    return is_near(p) ? "" : fmt::format("{} ({:.3g}, {:.3g}, {:.3g})", what, p.X(), p.Y(), p.Z());
}

/// Of an edge's curve in space, or of that in a face's parameters.
std::string fault_of_curve(const BRep_GCurve& curve) {
    const double first = curve.First();
    const double last = curve.Last();
    if (!std::isfinite(first) || !std::isfinite(last) || first > last) {
        return fmt::format("runs from the parameter {:.6g} to {:.6g}", first, last);
    }
    if (std::abs(first) >= kEndless || std::abs(last) >= kEndless) {
        return "";
    }
    for (const double t : {first, 0.5 * (first + last), last}) {
        std::string fault;
        if (curve.IsCurve3D() && !curve.Curve3D().IsNull()) {
            fault = fault_of_point("passes", curve.Curve3D()->Value(t).XYZ());
        } else if (curve.IsCurveOnSurface() && !curve.Surface().IsNull()) {
            const gp_Pnt2d p = curve.PCurve()->Value(t);
            fault = fault_of_point("has the parameters", {p.X(), p.Y(), 0.0});
            if (fault.empty()) {
                fault = fault_of_point("passes", curve.Surface()->Value(p.X(), p.Y()).XYZ());
            }
        }
        if (!fault.empty()) {
            return fault;
        }
    }
    return "";
}

std::string fault_of_edge(const TopoDS_Edge& edge) {
    const auto data = occ::cast<BRep_TEdge>(edge.TShape());
    if (!(data->Tolerance() <= kFarthest)) {
        return fmt::format("has the tolerance {:.3g}", data->Tolerance());
    }
    for (BRep_ListIteratorOfListOfCurveRepresentation it(data->Curves()); it.More(); it.Next()) {
        const auto curve = occ::cast<BRep_GCurve>(it.Value());
        if (curve.IsNull()) {
            continue;
        }
        // What OCCT cannot evaluate is for those to judge who need it.
        const Result<std::string> fault =
            occ::guarded("evaluating", [&] { return fault_of_curve(*curve); });
        if (fault && !fault->empty()) {
            return *fault;
        }
    }
    return "";
}

template <class Fault>
Result<void> check_all(const TopoDS_Shape& shape, TopAbs_ShapeEnum kind, const char* noun,
                       const std::filesystem::path& file, Fault&& fault_of) {
    TopTools_IndexedMapOfShape all;
    TopExp::MapShapes(shape, kind, all);
    for (int i = 1; i <= all.Extent(); ++i) {
        if (const std::string fault = fault_of(all(i)); !fault.empty()) {
            return fail(ErrorCode::Unreadable, "{} is damaged: {} {} {}", file.string(), noun, i,
                        fault);
        }
    }
    return {};
}

/// A binary BREP's orientations are bytes, which OCCT takes as they are, as places in a table of
/// four. So no explorer may go through the shape before this has.
Result<void> check_orientations(const TopoDS_Shape& whole, const std::filesystem::path& file) {
    TopTools_MapOfShape seen;
    std::vector<TopoDS_Shape> open = {whole};
    while (!open.empty()) {
        const TopoDS_Shape shape = open.back();
        open.pop_back();
        const auto orientation = static_cast<int>(shape.Orientation());
        if (orientation < TopAbs_FORWARD || orientation > TopAbs_EXTERNAL) {
            return fail(ErrorCode::Unreadable,
                        "{} is damaged: a part of it has orientation {}; there are 0 to 3",
                        file.string(), orientation);
        }
        if (!seen.Add(shape.Located({}).Oriented(TopAbs_FORWARD))) {
            continue;
        }
        for (TopoDS_Iterator it(shape, /*cumOri=*/Standard_False, /*cumLoc=*/Standard_False);
             it.More(); it.Next()) {
            open.push_back(it.Value());
        }
    }
    return {};
}

}  // namespace

Result<void> check_numbers(const TopoDS_Shape& shape, const std::filesystem::path& file) {
    return check_orientations(shape, file)
        .and_then([&] {
            return check_all(shape, TopAbs_VERTEX, "vertex", file, [](const TopoDS_Shape& s) {
                return fault_of_vertex(TopoDS::Vertex(s));
            });
        })
        .and_then([&] {
            return check_all(shape, TopAbs_FACE, "face", file,
                             [](const TopoDS_Shape& s) { return fault_of_face(TopoDS::Face(s)); });
        })
        .and_then([&] {
            return check_all(shape, TopAbs_EDGE, "edge", file,
                             [](const TopoDS_Shape& s) { return fault_of_edge(TopoDS::Edge(s)); });
        });
}

}  // namespace suture::io

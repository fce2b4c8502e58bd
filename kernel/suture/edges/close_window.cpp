#include "suture/edges/close_window.h"

#include "suture/occ/handle.h"
#include "suture/occ/topology.h"

#include <BRepTools.hxx>
#include <BRepTools_WireExplorer.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Geom2d_Curve.hxx>
#include <Geom2d_Line.hxx>
#include <GeomAPI_ProjectPointOnSurf.hxx>
#include <Geom_Curve.hxx>
#include <Geom_Surface.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Iterator.hxx>

#include <algorithm>
#include <cmath>
#include <vector>

namespace suture {
namespace {

/// Points a direction at which two surfaces are compared.
constexpr int kGrid = 6;

/// How far the end of a seam's piece may lie off the seam's own line, as a share of the period.
constexpr double kOnSeam = 1e-6;

double tolerance_of(const TopoDS_Face& face) {
    double tolerance = BRep_Tool::Tolerance(face);
    for (const TopoDS_Edge& edge : occ::edges_of(face)) {
        tolerance = std::max(tolerance, BRep_Tool::Tolerance(edge));
    }
    return tolerance;
}

/// Whether the second face, as far as its parameters reach, lies on the first one's surface.
bool on_one_surface(const TopoDS_Face& one, const TopoDS_Face& other) {
    const double tolerance = std::max(tolerance_of(one), tolerance_of(other));
    const auto surface = BRep_Tool::Surface(one);
    const auto second = BRep_Tool::Surface(other);
    double u0 = 0.0;
    double u1 = 0.0;
    double v0 = 0.0;
    double v1 = 0.0;
    BRepTools::UVBounds(other, u0, u1, v0, v1);
    for (int i = 0; i <= kGrid; ++i) {
        for (int j = 0; j <= kGrid; ++j) {
            const gp_Pnt point =
                second->Value(u0 + (u1 - u0) * i / kGrid, v0 + (v1 - v0) * j / kGrid);
            GeomAPI_ProjectPointOnSurf nearest(point, surface);
            if (nearest.NbPoints() == 0 || nearest.LowerDistance() > tolerance) {
                return false;
            }
        }
    }
    return true;
}

/// A piece of a seam, with where it runs in the face's parameters.
struct SeamPiece {
    TopoDS_Edge edge;      ///< FORWARD
    TopoDS_Vertex beyond;  ///< the end that is not on the window
    gp_Pnt2d forward;      ///< of that end, where the face uses the edge FORWARD
    gp_Pnt2d backward;     ///< of that end, where the face uses it REVERSED
};

SeamPiece piece_of(const TopoDS_Edge& edge, const TopTools_IndexedMapOfShape& window,
                   const TopoDS_Face& face) {
    SeamPiece piece;
    piece.edge = TopoDS::Edge(edge.Oriented(TopAbs_FORWARD));
    const TopoDS_Vertex first = TopExp::FirstVertex(piece.edge);
    const bool at_last = window.Contains(first);
    piece.beyond = at_last ? TopExp::LastVertex(piece.edge) : first;
    const auto end_on_face = [&](const TopoDS_Edge& used) {
        double from = 0.0;
        double to = 0.0;
        const auto pcurve = BRep_Tool::CurveOnSurface(used, face, from, to);
        return pcurve->Value(at_last ? to : from);
    };
    piece.forward = end_on_face(piece.edge);
    piece.backward = end_on_face(TopoDS::Edge(piece.edge.Reversed()));
    return piece;
}

struct WholeSeam {
    TopoDS_Edge edge;
    bool as_first = false;  ///< runs the way of the first piece
};

/// The edge that two pieces of a seam are parts of.
std::optional<WholeSeam> whole_seam(const SeamPiece& one, const SeamPiece& other,
                                    const TopoDS_Face& face) {
    const auto surface = BRep_Tool::Surface(face);
    const bool at_u = surface->IsUPeriodic() &&
                      std::abs(one.forward.X() - one.backward.X()) > 0.5 * surface->UPeriod();
    const bool at_v = surface->IsVPeriodic() &&
                      std::abs(one.forward.Y() - one.backward.Y()) > 0.5 * surface->VPeriod();
    if (at_u == at_v) {
        return std::nullopt;
    }
    const auto place = [&](const gp_Pnt2d& p) { return at_u ? p.X() : p.Y(); };
    const auto along = [&](const gp_Pnt2d& p) { return at_u ? p.Y() : p.X(); };
    const double period = at_u ? surface->UPeriod() : surface->VPeriod();
    const bool same_way = std::abs(place(one.forward) - place(other.forward)) < kOnSeam * period;
    const bool same_back = std::abs(place(one.forward) - place(other.backward)) < kOnSeam * period;
    if (same_way == same_back) {
        return std::nullopt;
    }
    const double from = along(one.forward);
    const double to = along(other.forward);
    const bool grows = to > from;
    // Where the face uses a piece forward it is walked from or towards its end.
    const bool leaves_end = TopExp::FirstVertex(one.edge).IsSame(one.beyond);
    const bool forward_grows = leaves_end == grows;
    const double here = forward_grows ? place(one.forward) : place(one.backward);
    const double there = forward_grows ? place(one.backward) : place(one.forward);
    const auto line = [&](double at) -> occ::Handle<Geom2d_Curve> {
        return at_u ? occ::make<Geom2d_Line>(gp_Pnt2d(at, 0.0), gp_Dir2d(0.0, 1.0))
                    : occ::make<Geom2d_Line>(gp_Pnt2d(0.0, at), gp_Dir2d(1.0, 0.0));
    };
    const occ::Handle<Geom_Curve> curve = at_u ? surface->UIso(here) : surface->VIso(here);
    const double tolerance =
        std::max(BRep_Tool::Tolerance(one.edge), BRep_Tool::Tolerance(other.edge));
    const BRep_Builder builder;
    TopoDS_Edge seam;
    builder.MakeEdge(seam, curve, tolerance);
    builder.UpdateEdge(seam, line(here), line(there), face, tolerance);
    builder.Range(seam, std::min(from, to), std::max(from, to));
    const TopoDS_Vertex& first = grows ? one.beyond : other.beyond;
    const TopoDS_Vertex& last = grows ? other.beyond : one.beyond;
    builder.Add(seam, first.Oriented(TopAbs_FORWARD));
    builder.Add(seam, last.Oriented(TopAbs_REVERSED));
    return WholeSeam{seam, forward_grows};
}

/// The wire without the window's edges, its seam whole again; none if that is not possible.
std::optional<TopoDS_Wire> across_seam(const TopoDS_Wire& wire,
                                       const TopTools_IndexedMapOfShape& window,
                                       const TopoDS_Face& face) {
    std::vector<TopoDS_Edge> left;
    TopTools_IndexedMapOfShape pieces;
    int walked = 0;
    for (BRepTools_WireExplorer walk(wire, face); walk.More(); walk.Next()) {
        const TopoDS_Edge& edge = walk.Current();
        ++walked;
        if (window.Contains(edge)) {
            continue;
        }
        left.push_back(edge);
        const bool touches =
            window.Contains(TopExp::FirstVertex(edge)) != window.Contains(TopExp::LastVertex(edge));
        if (touches && BRep_Tool::IsClosed(edge, face)) {
            pieces.Add(edge);
        } else if (touches) {
            return std::nullopt;
        }
    }
    if (pieces.Extent() != 2 || walked != wire.NbChildren()) {
        return std::nullopt;
    }
    const SeamPiece one = piece_of(TopoDS::Edge(pieces(1)), window, face);
    const SeamPiece other = piece_of(TopoDS::Edge(pieces(2)), window, face);
    const auto seam = whole_seam(one, other, face);
    if (!seam) {
        return std::nullopt;
    }
    const BRep_Builder builder;
    TopoDS_Wire result;
    builder.MakeWire(result);
    for (const TopoDS_Edge& edge : left) {
        if (edge.IsSame(one.edge)) {
            const bool forward = (edge.Orientation() == TopAbs_FORWARD) == seam->as_first;
            builder.Add(result, seam->edge.Oriented(forward ? TopAbs_FORWARD : TopAbs_REVERSED));
        } else if (!edge.IsSame(other.edge)) {
            builder.Add(result, edge);
        }
    }
    result.Closed(Standard_True);
    return result;
}

}  // namespace

std::optional<TopoDS_Face> close_window(const TopoDS_Face& around, const TopoDS_Face& inside) {
    if (!on_one_surface(around, inside)) {
        return std::nullopt;
    }
    TopTools_IndexedMapOfShape window;
    TopExp::MapShapes(inside, TopAbs_EDGE, window);
    TopExp::MapShapes(inside, TopAbs_VERTEX, window);
    const TopoDS_Face face = TopoDS::Face(around.Oriented(TopAbs_FORWARD));
    const BRep_Builder builder;
    TopoDS_Face result = TopoDS::Face(face.EmptyCopied());
    for (TopoDS_Iterator it(face); it.More(); it.Next()) {
        const auto edges = occ::edges_of(it.Value());
        const auto common = std::ranges::count_if(
            edges, [&](const TopoDS_Edge& edge) { return window.Contains(edge); });
        if (common == static_cast<std::ptrdiff_t>(edges.size())) {
            continue;
        }
        if (common == 0) {
            builder.Add(result, it.Value());
            continue;
        }
        const auto wire = across_seam(TopoDS::Wire(it.Value()), window, face);
        if (!wire) {
            return std::nullopt;
        }
        builder.Add(result, wire->Oriented(it.Value().Orientation()));
    }
    return TopoDS::Face(result.Oriented(around.Orientation()));
}

}  // namespace suture

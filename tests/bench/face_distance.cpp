#include "bench/face_distance.h"

#include <BRepAdaptor_Curve.hxx>
#include <BRepAdaptor_Surface.hxx>
#include <BRepTools.hxx>
#include <BRepTopAdaptor_FClass2d.hxx>
#include <BRep_Tool.hxx>
#include <Extrema_ExtPC.hxx>
#include <Extrema_ExtPS.hxx>
#include <Extrema_GenLocateExtPS.hxx>
#include <Precision.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>

#include <algorithm>
#include <cmath>
#include <deque>
#include <limits>

namespace suture::bench {
namespace {

constexpr int kSamplesAcross = 24;   // of a face that is measured
constexpr int kSamplesOnEdge = 24;   // per edge
constexpr int kStartsAcross = 48;    // where the search for the nearest point may start
constexpr double kTolerance = 1e-9;  // of parameters, in the searches
constexpr double kFoot = 1e-6;       // how far from a right angle a foot's may be, as a sine

struct Edge {
    BRepAdaptor_Curve curve;
    Extrema_ExtPC search;
};

}  // namespace

std::vector<FacePoint> grid_of(const TopoDS_Face& face, int across) {
    double u1 = 0.0;
    double u2 = 0.0;
    double v1 = 0.0;
    double v2 = 0.0;
    BRepTools::UVBounds(face, u1, u2, v1, v2);
    const BRepAdaptor_Surface surface(face, false);
    BRepTopAdaptor_FClass2d inside(face, Precision::PConfusion());
    std::vector<FacePoint> grid;
    for (int i = 0; i < across; ++i) {
        for (int j = 0; j < across; ++j) {
            const gp_Pnt2d uv(u1 + (u2 - u1) * (i + 0.5) / across,
                              v1 + (v2 - v1) * (j + 0.5) / across);
            if (inside.Perform(uv) == TopAbs_IN) {
                grid.push_back({uv, surface.Value(uv.X(), uv.Y())});
            }
        }
    }
    return grid;
}

std::vector<gp_Pnt> points_of(const TopoDS_Face& face) {
    std::vector<gp_Pnt> points;
    for (const FacePoint& at : grid_of(face, kSamplesAcross)) {
        points.push_back(at.point);
    }
    for (TopExp_Explorer at(face, TopAbs_EDGE); at.More(); at.Next()) {
        const TopoDS_Edge& edge = TopoDS::Edge(at.Current());
        if (BRep_Tool::Degenerated(edge)) {
            continue;
        }
        const BRepAdaptor_Curve curve(edge, face);  // on the surface, as the trimming has it
        const double first = curve.FirstParameter();
        const double step = (curve.LastParameter() - first) / kSamplesOnEdge;
        for (int i = 0; i <= kSamplesOnEdge; ++i) {
            points.push_back(curve.Value(first + i * step));
        }
    }
    return points;
}

struct FaceDistance::Data {
    explicit Data(const TopoDS_Face& face)
        : surface(face), inside(face, Precision::PConfusion()), grid(grid_of(face, kStartsAcross)) {
        search.Initialize(surface, surface.FirstUParameter(), surface.LastUParameter(),
                          surface.FirstVParameter(), surface.LastVParameter(), kTolerance,
                          kTolerance);
        for (TopExp_Explorer at(face, TopAbs_EDGE); at.More(); at.Next()) {
            const TopoDS_Edge& edge = TopoDS::Edge(at.Current());
            if (!BRep_Tool::Degenerated(edge)) {
                Edge& added = edges.emplace_back();
                added.curve = BRepAdaptor_Curve(edge, face);
                added.search.Initialize(added.curve, added.curve.FirstParameter(),
                                        added.curve.LastParameter(), kTolerance);
            }
        }
    }

    bool take(const Extrema_POnSurf& found, const gp_Pnt& point) {
        double u = 0.0;
        double v = 0.0;
        found.Parameter(u, v);
        const TopAbs_State state = inside.Perform(gp_Pnt2d(u, v));
        const bool in_face = state == TopAbs_IN || state == TopAbs_ON;
        if (in_face) {
            nearest = std::min(nearest, found.Value().Distance(point));
        }
        return in_face;
    }

    void project(const gp_Pnt& point) {
        search.Perform(point);
        for (int i = 1; search.IsDone() && i <= search.NbExt(); ++i) {
            take(search.Point(i), point);
        }
    }

    /// Whether a nearest point inside the face was found.
    bool start_from_grid(const gp_Pnt& point) {
        const auto start =
            std::min_element(grid.begin(), grid.end(), [&](const auto& a, const auto& b) {
                return a.point.SquareDistance(point) < b.point.SquareDistance(point);
            });
        if (start == grid.end()) {
            return false;
        }
        nearest = std::min(nearest, start->point.Distance(point));
        Extrema_GenLocateExtPS local(surface, kTolerance, kTolerance);
        local.Perform(point, start->parameters.X(), start->parameters.Y(), true);
        return local.IsDone() && is_foot(local.Point(), point) && take(local.Point(), point);
    }

    /// OCCT 7.8 returns where its search began if there is no foot near.
    [[nodiscard]] bool is_foot(const Extrema_POnSurf& found, const gp_Pnt& point) const {
        double u = 0.0;
        double v = 0.0;
        found.Parameter(u, v);
        gp_Pnt at;
        gp_Vec along_u;
        gp_Vec along_v;
        surface.D1(u, v, at, along_u, along_v);
        const gp_Vec way(at, point);
        const double flat = kFoot * way.Magnitude();
        return std::abs(way.Dot(along_u)) <= flat * along_u.Magnitude() &&
               std::abs(way.Dot(along_v)) <= flat * along_v.Magnitude();
    }

    void walk_boundary(const gp_Pnt& point) {
        for (Edge& edge : edges) {
            for (const double end : {edge.curve.FirstParameter(), edge.curve.LastParameter()}) {
                nearest = std::min(nearest, edge.curve.Value(end).Distance(point));
            }
            edge.search.Perform(point);
            for (int i = 1; edge.search.IsDone() && i <= edge.search.NbExt(); ++i) {
                nearest = std::min(nearest, edge.search.Point(i).Value().Distance(point));
            }
        }
    }

    BRepAdaptor_Surface surface;
    BRepTopAdaptor_FClass2d inside;
    Extrema_ExtPS search;
    std::vector<FacePoint> grid;
    std::deque<Edge> edges;  // the searches point to the curves
    double nearest = 0.0;
};

FaceDistance::FaceDistance(const TopoDS_Face& face) : data_(std::make_shared<Data>(face)) {}

double FaceDistance::operator()(const gp_Pnt& point) {
    data_->nearest = std::numeric_limits<double>::infinity();
    if (!data_->start_from_grid(point)) {
        // The nearest point is on the boundary, or the start was a bad one.
        data_->walk_boundary(point);
        data_->project(point);
    }
    return data_->nearest;
}

}  // namespace suture::bench

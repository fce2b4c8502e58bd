#include "files/mesh_faces.h"

#include "suture/occ/handle.h"
#include "suture/occ/topology.h"

#include <fmt/format.h>

#include <BRepAdaptor_Curve.hxx>
#include <BRepCheck_Wire.hxx>
#include <BRepMesh_IncrementalMesh.hxx>
#include <BRepTools.hxx>
#include <BRep_Tool.hxx>
#include <GCPnts_AbscissaPoint.hxx>
#include <Geom_Surface.hxx>
#include <IMeshTools_Parameters.hxx>
#include <Poly_Triangulation.hxx>
#include <Precision.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>

#include <algorithm>
#include <map>

namespace suture::io {

namespace {

/// How much finer a face is meshed at last.
constexpr double kFinest = 1.0 / 32.0;

void mesh(const TopoDS_Shape& shape, double deflection, double angle) {
    IMeshTools_Parameters parameters;
    parameters.Deflection = deflection;
    parameters.Angle = angle;
    parameters.InParallel = true;
    // Finer triangles that are there, and the points of their edges, stay.
    parameters.AllowQualityDecrease = false;
    const BRepMesh_IncrementalMesh mesher(shape, parameters);
}

bool has_triangles(const TopoDS_Face& face) {
    TopLoc_Location location;
    const occ::Handle<Poly_Triangulation> grid = BRep_Tool::Triangulation(face, location);
    return !grid.IsNull() && grid->NbTriangles() > 0;
}

/// Of the surface over the face's parameter box, by chords: at least the face's own if it is small.
double area_of_box(const TopoDS_Face& face) {
    constexpr int kCells = 32;
    double u0 = 0.0;
    double u1 = 0.0;
    double v0 = 0.0;
    double v1 = 0.0;
    BRepTools::UVBounds(face, u0, u1, v0, v1);
    const occ::Handle<Geom_Surface> surface = BRep_Tool::Surface(face);
    const auto at = [&](int i, int k) {
        return surface->Value(u0 + (u1 - u0) * i / kCells, v0 + (v1 - v0) * k / kCells);
    };
    double sum = 0.0;
    for (int i = 0; i < kCells; ++i) {
        for (int k = 0; k < kCells; ++k) {
            const gp_Vec one(at(i, k), at(i + 1, k + 1));
            const gp_Vec two(at(i + 1, k), at(i, k + 1));
            sum += 0.5 * one.CrossMagnitude(two);
        }
    }
    return sum;
}

/// Nowhere wider than its edges are exact, as the end of a wing that a modeller closes to a line.
bool is_without_area(const TopoDS_Face& face) {
    double length = 0.0;
    double tolerance = Precision::Confusion();
    for (TopExp_Explorer edge(face, TopAbs_EDGE); edge.More(); edge.Next()) {
        const TopoDS_Edge& side = TopoDS::Edge(edge.Current());
        tolerance = std::max(tolerance, BRep_Tool::Tolerance(side));
        if (!BRep_Tool::Degenerated(side)) {
            length += GCPnts_AbscissaPoint::Length(BRepAdaptor_Curve(side));
        }
    }
    return area_of_box(face) <= tolerance * std::max(length, tolerance);
}

std::string reason_of(const TopoDS_Face& face) {
    for (TopExp_Explorer wire(face, TopAbs_WIRE); wire.More(); wire.Next()) {
        const occ::Handle<BRepCheck_Wire> check = new BRepCheck_Wire(TopoDS::Wire(wire.Current()));
        TopoDS_Edge one;
        TopoDS_Edge other;
        if (check->Closed2d(face) != BRepCheck_NoError) {
            return "its boundary is not closed";
        }
        if (check->SelfIntersect(face, one, other) != BRepCheck_NoError) {
            return "its boundary crosses itself";
        }
    }
    return "OCCT's mesher fails on it";
}

}  // namespace

std::string text_of(const UnmeshedFace& face) {
    return fmt::format("face {}{} could not be meshed: {}", face.face,
                       face.part.empty() ? "" : fmt::format(" of part '{}'", face.part),
                       face.reason);
}

std::vector<UnmeshedFace> triangulate(const TopoDS_Shape& shape, double deflection, double angle) {
    const occ::Numbering numbers(shape);
    const auto face_at = [&](int face) { return TopoDS::Face(numbers.faces(face)); };
    std::vector<UnmeshedFace> result;
    std::map<int, double> finer;  // by face: the part of the deflection with which it is tried
    for (bool again = true; again;) {
        BRepTools::Clean(shape);
        for (const auto& [face, factor] : finer) {
            mesh(face_at(face), factor * deflection, angle);
        }
        mesh(shape, deflection, angle);
        result.clear();
        again = false;
        for (int face = 1; face <= numbers.faces.Extent(); ++face) {
            if (has_triangles(face_at(face))) {
                continue;
            }
            if (is_without_area(face_at(face))) {
                result.push_back({face, "", false, "it has no area"});
                continue;
            }
            result.push_back({face, "", true, reason_of(face_at(face))});
            double& factor = finer.emplace(face, 1.0).first->second;
            again = again || factor > kFinest;
            factor = std::max(0.5 * factor, kFinest);
        }
    }
    return result;
}

}  // namespace suture::io

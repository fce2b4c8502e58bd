#include "report/face_mesh.h"

#include "suture/occ/guard.h"
#include "suture/occ/handle.h"
#include "suture/occ/topology.h"

#include <BRepAdaptor_Curve.hxx>
#include <BRepMesh_IncrementalMesh.hxx>
#include <BRepTools.hxx>
#include <BRep_Tool.hxx>
#include <GeomAdaptor_Surface.hxx>
#include <Poly_PolygonOnTriangulation.hxx>
#include <Poly_Triangulation.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>

#include <algorithm>
#include <cmath>

namespace suture::report {
namespace {

// Each further try is this much coarser, in both deflections.
constexpr double kCoarser = 2.0;
constexpr int kTries = 4;
// Facets may not turn by more than this, however large the model: round things stay round.
constexpr double kMostAngular = 0.6;

// Points of an edge that lies on no triangulated face.
constexpr int kBareEdgePoints = 17;

std::size_t count_triangles(const occ::Numbering& numbering) {
    std::size_t count = 0;
    for (int i = 1; i <= numbering.faces.Extent(); ++i) {
        TopLoc_Location location;
        const auto mesh = BRep_Tool::Triangulation(TopoDS::Face(numbering.faces(i)), location);
        count += mesh.IsNull() ? 0 : static_cast<std::size_t>(mesh->NbTriangles());
    }
    return count;
}

std::int16_t to_int16(double value) {
    return static_cast<std::int16_t>(std::lround(std::clamp(value, -1.0, 1.0) * 32767.0));
}

/// The unit sphere folded onto a square: both coordinates in [-1, 1].
void push_octahedral(const gp_Dir& n, std::vector<std::int16_t>& normals) {
    const double sum = std::abs(n.X()) + std::abs(n.Y()) + std::abs(n.Z());
    double x = n.X() / sum;
    double y = n.Y() / sum;
    if (n.Z() < 0.0) {
        const double folded = (1.0 - std::abs(y)) * (x < 0.0 ? -1.0 : 1.0);
        y = (1.0 - std::abs(x)) * (y < 0.0 ? -1.0 : 1.0);
        x = folded;
    }
    normals.push_back(to_int16(x));
    normals.push_back(to_int16(y));
}

/// Normal and principal curvatures of a surface, or the facets' normal where it is singular.
struct SurfacePoint {
    gp_Vec normal;
    std::array<double, 2> curvature = {0.0, 0.0};
};

SurfacePoint evaluate(const GeomAdaptor_Surface& surface, const gp_Pnt2d& uv,
                      const gp_Vec& facet_normal) {
    gp_Pnt P;
    gp_Vec Su, Sv, Suu, Svv, Suv;
    surface.D2(uv.X(), uv.Y(), P, Su, Sv, Suu, Svv, Suv);
    const gp_Vec cross = Su.Crossed(Sv);
    constexpr double kSingular = 1e-9;
    if (cross.Magnitude() <= kSingular * Su.Magnitude() * Sv.Magnitude()) {
        return {facet_normal, {}};
    }
    SurfacePoint point;
    point.normal = cross.Normalized();
    const double E = Su * Su;
    const double F = Su * Sv;
    const double G = Sv * Sv;
    const double L = point.normal * Suu;
    const double M = point.normal * Suv;
    const double N = point.normal * Svv;
    const double determinant = E * G - F * F;
    const double mean = (E * N - 2.0 * F * M + G * L) / (2.0 * determinant);
    const double gauss = (L * N - M * M) / determinant;
    const double root = std::sqrt(std::max(0.0, mean * mean - gauss));
    point.curvature = {mean + root, mean - root};
    return point;
}

std::vector<gp_Vec> facet_normals(const Poly_Triangulation& mesh) {
    std::vector<gp_Vec> sums(static_cast<std::size_t>(mesh.NbNodes()));
    for (int i = 1; i <= mesh.NbTriangles(); ++i) {
        std::array<int, 3> n = {};
        mesh.Triangle(i).Get(n[0], n[1], n[2]);
        const gp_Pnt a = mesh.Node(n[0]);
        const gp_Vec area = gp_Vec(a, mesh.Node(n[1])).Crossed(gp_Vec(a, mesh.Node(n[2])));
        for (const int node : n) {
            sums[static_cast<std::size_t>(node - 1)] += area;
        }
    }
    return sums;
}

void add_face(const TopoDS_Face& face, FaceMesh& result) {
    TopLoc_Location location;
    const auto mesh = BRep_Tool::Triangulation(face, location);
    if (mesh.IsNull() || mesh->NbTriangles() == 0) {
        ++result.faces_without;
        return;
    }
    TopLoc_Location surface_location;
    const GeomAdaptor_Surface surface(BRep_Tool::Surface(face, surface_location));
    const gp_Trsf to_model = location.Transformation();
    const double scale = std::abs(to_model.ScaleFactor());
    const bool reversed = face.Orientation() == TopAbs_REVERSED;
    const double sign = reversed ? -1.0 : 1.0;
    const auto base = static_cast<std::uint32_t>(result.points.size() / 3);
    const std::vector<gp_Vec> facets = facet_normals(*mesh);
    for (int i = 1; i <= mesh->NbNodes(); ++i) {
        const gp_Pnt at = mesh->Node(i).Transformed(to_model);
        for (int k = 1; k <= 3; ++k) {
            result.points.push_back(static_cast<float>(at.Coord(k)));
        }
        const gp_Vec& facet = facets[static_cast<std::size_t>(i - 1)];
        SurfacePoint point{facet, {}};
        if (mesh->HasUVNodes()) {
            point = evaluate(surface, mesh->UVNode(i), facet);
        }
        gp_Vec normal = (sign * point.normal).Transformed(to_model);
        if (normal.Magnitude() <= gp::Resolution()) {
            normal = gp_Vec(0, 0, 1);
        }
        push_octahedral(gp_Dir(normal), result.normals);
        const auto [high, low] =
            std::minmax({sign * point.curvature[0], sign * point.curvature[1]}, std::greater<>());
        result.curvatures.push_back(static_cast<float>(high / scale));
        result.curvatures.push_back(static_cast<float>(low / scale));
    }
    const bool turned = reversed != to_model.IsNegative();
    for (int i = 1; i <= mesh->NbTriangles(); ++i) {
        std::array<int, 3> n = {};
        mesh->Triangle(i).Get(n[0], n[1], n[2]);
        if (turned) {
            std::swap(n[1], n[2]);
        }
        for (const int node : n) {
            result.corners.push_back(base + static_cast<std::uint32_t>(node - 1));
        }
    }
}

void push_point(const gp_Pnt& at, std::vector<float>& points) {
    for (int k = 1; k <= 3; ++k) {
        points.push_back(static_cast<float>(at.Coord(k)));
    }
}

/// The edge as the triangles of its face have it, else by points of its curve.
void add_edge(const TopoDS_Edge& edge, FaceMesh& result) {
    occ::Handle<Poly_PolygonOnTriangulation> polygon;
    occ::Handle<Poly_Triangulation> mesh;
    TopLoc_Location location;
    BRep_Tool::PolygonOnTriangulation(edge, polygon, mesh, location);
    if (!polygon.IsNull() && !mesh.IsNull()) {
        for (int i = 1; i <= polygon->NbNodes(); ++i) {
            push_point(mesh->Node(polygon->Node(i)).Transformed(location.Transformation()),
                       result.edge_points);
        }
        return;
    }
    if (BRep_Tool::Degenerated(edge)) {
        return;
    }
    const BRepAdaptor_Curve curve(edge);
    for (int i = 0; i < kBareEdgePoints; ++i) {
        const double s = static_cast<double>(i) / (kBareEdgePoints - 1);
        push_point(curve.Value((1.0 - s) * curve.FirstParameter() + s * curve.LastParameter()),
                   result.edge_points);
    }
}

void mesh_shape(const TopoDS_Shape& shape, const occ::Numbering& numbering,
                const FaceMeshOptions& options) {
    double linear = options.relative_deflection * occ::diagonal(shape);
    double angular = options.angular_deflection;
    if (linear <= 0.0) {
        return;
    }
    for (int i = 0; i < kTries; ++i) {
        BRepTools::Clean(shape);
        const BRepMesh_IncrementalMesh mesher(shape, linear, /*isRelative=*/false, angular,
                                              /*isInParallel=*/true);
        if (count_triangles(numbering) <= options.most_triangles || angular >= kMostAngular) {
            return;
        }
        linear *= kCoarser * kCoarser;
        angular = std::min(kCoarser * angular, kMostAngular);
    }
}

}  // namespace

Result<FaceMesh> make_face_mesh(const TopoDS_Shape& shape, const FaceMeshOptions& options,
                                const Progress& progress) {
    FaceMesh result;
    result.first.push_back(0);
    result.edge_first.push_back(0);
    if (shape.IsNull()) {
        return result;
    }
    const occ::Numbering numbering(shape);
    const auto meshed =
        occ::guarded("meshing the model", [&] { mesh_shape(shape, numbering, options); });
    if (!meshed) {
        return tl::unexpected(meshed.error());
    }
    if (progress.cancelled()) {
        return fail(ErrorCode::Cancelled, "the report was stopped");
    }
    return occ::guarded("drawing the model", [&] {
        for (int i = 1; i <= numbering.faces.Extent(); ++i) {
            add_face(TopoDS::Face(numbering.faces(i)), result);
            result.first.push_back(static_cast<std::uint32_t>(result.corners.size() / 3));
        }
        for (int i = 1; i <= numbering.edges.Extent(); ++i) {
            add_edge(TopoDS::Edge(numbering.edges(i)), result);
            result.edge_first.push_back(static_cast<std::uint32_t>(result.edge_points.size() / 3));
        }
        return result;
    });
}

}  // namespace suture::report

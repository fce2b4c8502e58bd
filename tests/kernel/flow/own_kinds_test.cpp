#include "support/properties.h"
#include "suture/fill_holes.h"
#include "suture/occ/handle.h"
#include "suture/occ/topology.h"

#include "kernel/flow/placements.h"
#include "kernel/flow/swept_sheets.h"
#include <gtest/gtest.h>

#include <BRepAdaptor_Surface.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepBuilderAPI_Sewing.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepMesh_IncrementalMesh.hxx>
#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <GeomAPI_Interpolate.hxx>
#include <GeomAPI_ProjectPointOnSurf.hxx>
#include <GeomFill.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_OffsetSurface.hxx>
#include <Poly_Triangulation.hxx>
#include <TColStd_HArray1OfReal.hxx>
#include <TColgp_HArray1OfPnt.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>

#include <algorithm>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace suture {
namespace {

using placements::placed;
using placements::Placement;
using swept_sheets::Sweep;
using swept_sheets::swept;
using test::area;

/// A face whose surface is no B-spline, lost from among neighbours that are.
struct LostPiece {
    TopoDS_Face face;
    TopoDS_Compound around;
};

constexpr double kWide = 2.0;

/// One side of a piece of a surface: from one point to another in (u, v), and the way out.
struct PieceSide {
    gp_XY from, to, out;
};

/// A ruled strip along a side that is tangent to the piece, `off` beside it.
TopoDS_Face strip(const Geom_Surface& surface, const PieceSide& side, double off) {
    constexpr int kPoints = 61;
    const auto parameters = occ::make<TColStd_HArray1OfReal>(1, kPoints);
    const auto near = occ::make<TColgp_HArray1OfPnt>(1, kPoints);
    const auto far = occ::make<TColgp_HArray1OfPnt>(1, kPoints);
    const gp_XY along = side.to - side.from;
    gp_Vec ends[2];
    for (int k = 1; k <= kPoints; ++k) {
        const double t = (k - 1.0) / (kPoints - 1.0);
        const gp_XY uv = side.from + t * along;
        gp_Pnt p;
        gp_Vec du;
        gp_Vec dv;
        surface.D1(uv.X(), uv.Y(), p, du, dv);
        p.Translate(du.Crossed(dv).Normalized() * off);
        const gp_Vec out = side.out.X() * du + side.out.Y() * dv;
        parameters->SetValue(k, t);
        near->SetValue(k, p);
        far->SetValue(k, p.Translated(out.Normalized() * kWide));
        if (k == 1 || k == kPoints) {
            ends[k == 1 ? 0 : 1] = along.X() * du + along.Y() * dv;
        }
    }
    GeomAPI_Interpolate inner(near, parameters, Standard_False, 0.0);
    inner.Load(ends[0], ends[1], /*Scale=*/Standard_False);
    inner.Perform();
    GeomAPI_Interpolate outer(far, parameters, Standard_False, 0.0);
    outer.Perform();
    return BRepBuilderAPI_MakeFace(GeomFill::Surface(inner.Curve(), outer.Curve()), 1e-7);
}

/// A parallelogram beside a corner of a piece.
TopoDS_Face patch_beside(const Geom_Surface& surface, double u, double v, int to_u, int to_v) {
    gp_Pnt p;
    gp_Vec du;
    gp_Vec dv;
    surface.D1(u, v, p, du, dv);
    gp_Vec a = to_u * kWide * du.Normalized();
    gp_Vec b = to_v * kWide * dv.Normalized();
    if (to_u * to_v < 0) {
        std::swap(a, b);
    }
    BRepBuilderAPI_MakePolygon outline(p, p.Translated(a), p.Translated(a + b), p.Translated(b),
                                       /*Close=*/Standard_True);
    return BRepBuilderAPI_MakeFace(outline.Wire());
}

/// A piece of a surface, and strips around it that are tangent to it, but no continuation.
///
/// Input    noise: how far the strips lie beside the piece, to either side by turns.
LostPiece cut(const occ::Handle<Geom_Surface>& surface, const TopoDS_Face& sheet, double noise) {
    double u0 = 0.0;
    double u1 = 0.0;
    double v0 = 0.0;
    double v1 = 0.0;
    BRepTools::UVBounds(sheet, u0, u1, v0, v1);
    const double a = u0 + 0.3 * (u1 - u0);
    const double b = u0 + 0.75 * (u1 - u0);
    const double c = v0 + 0.2 * (v1 - v0);
    const double d = v0 + 0.7 * (v1 - v0);
    LostPiece piece;
    piece.face = BRepBuilderAPI_MakeFace(surface, a, b, c, d, 1e-7);
    BRepBuilderAPI_Sewing sewing(1e-4);
    sewing.Add(strip(*surface, {{b, c}, {a, c}, {0, -1}}, noise));
    sewing.Add(strip(*surface, {{b, d}, {b, c}, {1, 0}}, -noise));
    sewing.Add(strip(*surface, {{a, d}, {b, d}, {0, 1}}, noise));
    sewing.Add(strip(*surface, {{a, c}, {a, d}, {-1, 0}}, -noise));
    sewing.Add(patch_beside(*surface, a, c, -1, -1));
    sewing.Add(patch_beside(*surface, b, c, 1, -1));
    sewing.Add(patch_beside(*surface, b, d, 1, 1));
    sewing.Add(patch_beside(*surface, a, d, -1, 1));
    sewing.Perform();
    const BRep_Builder builder;
    builder.MakeCompound(piece.around);
    builder.Add(piece.around, sewing.SewedShape());
    return piece;
}

double largest_distance(const TopoDS_Face& face, const occ::Handle<Geom_Surface>& surface,
                        double deflection) {
    BRepMesh_IncrementalMesh(face, deflection);
    TopLoc_Location place;
    const auto mesh = BRep_Tool::Triangulation(face, place);
    double largest = 0.0;
    for (int i = 1; i <= mesh->NbNodes(); i += 3) {
        const GeomAPI_ProjectPointOnSurf foot(mesh->Node(i).Transformed(place), surface);
        largest = std::max(largest, foot.LowerDistance());
    }
    return largest;
}

/// Fills the hole in a model; its new face has to be the lost one, of that kind.
void expect_given_back(const TopoDS_Shape& open, const TopoDS_Shape& lost, double scale,
                       GeomAbs_SurfaceType type, const std::string& kind, const std::string& from) {
    FillRequest request;
    request.method = "recognise";
    const auto outcome = fill_holes(open, occ::Numbering(open), request);
    ASSERT_TRUE(outcome) << outcome.error().message;
    ASSERT_EQ(outcome->new_faces.size(), 1U) << outcome->holes.front().reason;
    const auto filled = std::ranges::find_if(
        outcome->holes, [](const HoleReport& hole) { return hole.status == FillStatus::Filled; });
    ASSERT_NE(filled, outcome->holes.end());
    EXPECT_NE(filled->recognised->from.find(from), std::string::npos) << filled->recognised->from;
    EXPECT_EQ(filled->recognised->kind, kind);
    EXPECT_EQ(filled->patches.front().kind, kind);
    const TopoDS_Face& face = outcome->new_faces.front();
    EXPECT_EQ(BRepAdaptor_Surface(face).GetType(), type);
    EXPECT_TRUE(BRepCheck_Analyzer(outcome->shape).IsValid());
    EXPECT_NEAR(area(face), area(lost), 1e-5 * area(lost));
    EXPECT_LT(largest_distance(face, BRep_Tool::Surface(TopoDS::Face(lost)), 0.05 * scale),
              1e-5 * scale);
}

/// Turned, moved and mirrored: such a piece has a mirror plane of its own.
gp_Trsf far_away() {
    gp_Trsf turn;
    turn.SetRotation(gp_Ax1(gp_Pnt(4, 5, 6), gp_Dir(1, 0.3, -0.5)), 0.8);
    gp_Trsf move;
    move.SetTranslation(gp_Vec(60, -20, 10));
    gp_Trsf mirror;
    mirror.SetMirror(gp_Ax2(gp_Pnt(1, 2, 3), gp_Dir(0.2, 1, 0.4)));
    return move * turn * mirror;
}

/// As it is, turned and small, far away.
std::vector<Placement> places() {
    const std::vector<Placement> all = placements::all();
    return {all[0], all[2], all[4]};
}

TEST(Recognise, GivesTwinsOfRevolvedExtrudedAndOffsetFacesTheirOwnKind) {
    const std::map<Sweep, std::pair<std::string, GeomAbs_SurfaceType>> kinds = {
        {Sweep::Turned, {"surface of revolution", GeomAbs_SurfaceOfRevolution}},
        {Sweep::Pushed, {"surface of extrusion", GeomAbs_SurfaceOfExtrusion}},
        {Sweep::Offset, {"offset surface", GeomAbs_OffsetSurface}}};
    for (const auto& [sweep, kind] : kinds) {
        const TopoDS_Face sheet = swept(sweep);
        const LostPiece piece = cut(BRep_Tool::Surface(sheet), sheet, 0.0);
        TopoDS_Compound open;
        const BRep_Builder builder;
        builder.MakeCompound(open);
        builder.Add(open, piece.around);
        builder.Add(open, BRepBuilderAPI_Transform(piece.face, far_away(), /*Copy=*/true).Shape());
        for (const Placement& placement : places()) {
            SCOPED_TRACE(placement.name + ", " + kind.first);
            expect_given_back(placed(open, placement), placed(piece.face, placement),
                              placement.scale, kind.second, kind.first, "twin of face");
        }
    }
}

// The other wall of a shell: a whole sheet, and the one that is 0.7 beside it lacks a piece.
TEST(Recognise, GivesOffsetsOfRevolvedFacesTheirOwnKind) {
    const TopoDS_Face sheet = swept(Sweep::Turned);
    const LostPiece piece =
        cut(occ::make<Geom_OffsetSurface>(BRep_Tool::Surface(sheet), 0.7), sheet, 2e-6);
    TopoDS_Compound open;
    const BRep_Builder builder;
    builder.MakeCompound(open);
    builder.Add(open, piece.around);
    builder.Add(open, sheet);
    for (const Placement& placement : places()) {
        SCOPED_TRACE(placement.name);
        expect_given_back(placed(open, placement), placed(piece.face, placement), placement.scale,
                          GeomAbs_OffsetSurface, "offset surface", "offset by");
    }
}

}  // namespace
}  // namespace suture

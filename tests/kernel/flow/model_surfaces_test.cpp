#include "support/grids.h"
#include "support/properties.h"
#include "suture/fill_holes.h"
#include "suture/occ/topology.h"

#include "kernel/flow/placements.h"
#include "kernel/flow/rounded_models.h"
#include "kernel/flow/swept_sheets.h"
#include <gtest/gtest.h>

#include <BRepAdaptor_Curve.hxx>
#include <BRepAdaptor_Surface.hxx>
#include <BRepAlgoAPI_Common.hxx>
#include <BRepAlgoAPI_Cut.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepFilletAPI_MakeFillet.hxx>
#include <BRepMesh_IncrementalMesh.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRep_Tool.hxx>
#include <GeomAPI_ProjectPointOnSurf.hxx>
#include <Poly_Triangulation.hxx>

#include <cmath>
#include <map>

namespace suture {
namespace {

using placements::placed;
using placements::Placement;
using rounded::middle;
using swept_sheets::Sweep;
using swept_sheets::swept;
using test::area;

TEST(Recognise, GivesBackWindowsOfRevolvedExtrudedAndOffsetFacesInTheirOwnKind) {
    const std::map<Sweep, std::pair<std::string, GeomAbs_SurfaceType>> kinds = {
        {Sweep::Turned, {"surface of revolution", GeomAbs_SurfaceOfRevolution}},
        {Sweep::Pushed, {"surface of extrusion", GeomAbs_SurfaceOfExtrusion}},
        {Sweep::Offset, {"offset surface", GeomAbs_OffsetSurface}}};
    for (const Placement& placement : placements::all()) {
        for (const auto& [sweep, kind] : kinds) {
            SCOPED_TRACE(placement.name + ", " + kind.first);
            const bool turned = sweep != Sweep::Pushed;
            // A drill marks the window; behind a revolved sheet's half-way angle, or across the
            // other.
            const gp_Ax2 axis = turned ? gp_Ax2(gp_Pnt(0, 0, 12), gp_Dir(1, 1, 0.1))
                                       : gp_Ax2(gp_Pnt(0, 12, 7), gp_Dir(1, 0.1, 0.2));
            const TopoDS_Shape drill = BRepPrimAPI_MakeCylinder(axis, 3.0, 40.0).Shape();
            const TopoDS_Face sheet = swept(sweep);
            const TopoDS_Shape window = placed(BRepAlgoAPI_Common(sheet, drill).Shape(), placement);
            const TopoDS_Shape open = placed(BRepAlgoAPI_Cut(sheet, drill).Shape(), placement);
            ASSERT_GT(area(window), 20.0 * placement.scale * placement.scale);
            FillRequest request;
            request.method = "recognise";
            const auto outcome = fill_holes(open, occ::Numbering(open), request);
            ASSERT_TRUE(outcome) << outcome.error().message;
            const HoleReport& hole = outcome->holes.front();
            ASSERT_EQ(hole.status, FillStatus::Filled) << hole.reason;
            EXPECT_NE(hole.recognised->from.find("the surface of face"), std::string::npos);
            EXPECT_EQ(hole.recognised->kind, kind.first);
            EXPECT_EQ(hole.patches.front().kind, kind.first);
            EXPECT_TRUE(BRepCheck_Analyzer(outcome->shape).IsValid());
            ASSERT_EQ(outcome->new_faces.size(), 1U);
            EXPECT_EQ(BRepAdaptor_Surface(outcome->new_faces.front()).GetType(), kind.second);
            EXPECT_NEAR(area(outcome->new_faces.front()), area(window), 2e-6 * area(window));
            // Every point of the new face lies on the lost one's surface, the border as near as
            // OCCT has cut it.
            const auto surface = BRep_Tool::Surface(occ::faces_of(window).front());
            BRepMesh_IncrementalMesh(outcome->new_faces.front(), 0.05 * placement.scale);
            TopLoc_Location place;
            const auto mesh = BRep_Tool::Triangulation(outcome->new_faces.front(), place);
            ASSERT_FALSE(mesh.IsNull());
            for (int i = 1; i <= mesh->NbNodes(); i += 7) {
                const GeomAPI_ProjectPointOnSurf foot(mesh->Node(i).Transformed(place), surface);
                ASSERT_GT(foot.NbPoints(), 0);
                EXPECT_LT(foot.LowerDistance(), 2e-7 * placement.scale);
            }
        }
    }
}

TEST(Recognise, LeavesASmoothFillThatIsNoCopyAsItIs) {
    const TopoDS_Face sheet = swept(Sweep::Turned);
    const TopoDS_Shape drill =
        BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(0, 0, 12), gp_Dir(1, 1, 0.1)), 3.0, 40.0).Shape();
    const TopoDS_Shape open = BRepAlgoAPI_Cut(sheet, drill).Shape();
    FillRequest request;
    request.method = "mvs";
    const auto outcome = fill_holes(open, occ::Numbering(open), request);
    ASSERT_TRUE(outcome) << outcome.error().message;
    ASSERT_EQ(outcome->holes.front().status, FillStatus::Filled) << outcome->holes.front().reason;
    EXPECT_EQ(outcome->holes.front().patches.front().kind, "B-spline surface");
    for (const TopoDS_Face& face : outcome->new_faces) {
        EXPECT_EQ(BRepAdaptor_Surface(face).GetType(), GeomAbs_BSplineSurface);
    }
}

/// A box with two edges rounded by a radius that grows along them, one the other's mirror image.
TopoDS_Shape growing_fillets() {
    const TopoDS_Shape box = BRepPrimAPI_MakeBox(30.0, 25.0, 20.0).Shape();
    BRepFilletAPI_MakeFillet fillet(box);
    for (const TopoDS_Edge& edge : occ::edges_of(box)) {
        const gp_Pnt p = middle(edge);
        if (std::abs(p.Z() - 20.0) < 1e-6 && std::abs(p.Y() - 12.5) < 1e-6) {
            const bool upwards = BRepAdaptor_Curve(edge).Value(0.0).Y() < 12.5;
            fillet.Add(upwards ? 2.0 : 4.0, upwards ? 4.0 : 2.0, edge);
        }
    }
    fillet.Build();
    return fillet.Shape();
}

TEST(Recognise, GivesBackTheMirroredTwinOfAFace) {
    const TopoDS_Shape body = growing_fillets();
    const auto faces = occ::faces_of(body);
    int found = 0;
    for (int i = 0; i < static_cast<int>(faces.size()); ++i) {
        if (BRepAdaptor_Surface(faces[static_cast<std::size_t>(i)]).GetType() == GeomAbs_Plane) {
            continue;
        }
        ++found;
        const TopoDS_Shape open = grids::without_faces(body, {i});
        FillRequest request;
        request.method = "recognise";
        const auto outcome = fill_holes(open, occ::Numbering(open), request);
        ASSERT_TRUE(outcome) << outcome.error().message;
        const HoleReport& hole = outcome->holes.front();
        ASSERT_EQ(hole.status, FillStatus::Filled) << hole.reason;
        EXPECT_NE(hole.recognised->from.find("mirrored twin of face"), std::string::npos)
            << hole.recognised->from;
        EXPECT_NEAR(area(outcome->shape), area(body), 1e-7 * area(body));
        // Around the hole alone there is none.
        request.recognise = Scope::Neighbours;
        const auto without = fill_holes(open, occ::Numbering(open), request);
        ASSERT_TRUE(without) << without.error().message;
        EXPECT_EQ(without->holes.front().status, FillStatus::Refused);
    }
    EXPECT_EQ(found, 2);
}

TEST(Recognise, IsLeftOutOfAutoWhereItIsNotWanted) {
    const TopoDS_Shape body = growing_fillets();
    FillRequest request;
    request.recognise.reset();
    for (int i = 0; i < 2; ++i) {
        const TopoDS_Shape open = grids::without_faces(body, {i});
        const auto outcome = fill_holes(open, occ::Numbering(open), request);
        ASSERT_TRUE(outcome) << outcome.error().message;
        EXPECT_FALSE(outcome->holes.front().recognised);
    }
}

}  // namespace
}  // namespace suture

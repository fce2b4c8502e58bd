#include "suture/sew/sew_shape.h"

#include "support/properties.h"
#include "suture/base/tolerance.h"
#include "suture/detect/shell_graph.h"
#include "suture/occ/handle.h"
#include "suture/sew/bodies.h"

#include "kernel/detect/shapes.h"

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepGProp.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <GC_MakeArcOfCircle.hxx>
#include <GProp_GProps.hxx>
#include <Geom_TrimmedCurve.hxx>
#include <gp_Circ.hxx>

#include <algorithm>
#include <cmath>
#include <limits>

namespace suture {
namespace {

using test::area;
using test::Census;
using test::census;
using test::volume;

SewnShape sew(const TopoDS_Shape& shape, double tolerance = 0.0) {
    auto result = sew_shape(shape, tolerance);
    EXPECT_TRUE(result.has_value()) << result.error().message;
    return result.value_or(SewnShape());
}

void expect_sewn_as(const TopoDS_Shape& original, const SewnShape& sewn) {
    EXPECT_TRUE(sewn.changed);
    EXPECT_EQ(sewn.free_edges_after, 0);
    EXPECT_EQ(occ::faces_of(sewn.shape).size(), occ::faces_of(original).size());
    EXPECT_NEAR(volume(sewn.shape), volume(original), 1e-9 * volume(original));
    EXPECT_NEAR(area(sewn.shape), area(original), 1e-9 * area(original));
}

/// Six loose faces of a box, of which the top and three sides are moved out by `gap`.
TopoDS_Compound box_with_gaps(double gap) {
    const double g = gap;
    return test::compound_of({
        test::polygon({{0, 0, 0}, {0, 20, 0}, {10, 20, 0}, {10, 0, 0}}),
        test::polygon({{0, 0, 30 + g}, {10, 0, 30 + g}, {10, 20, 30 + g}, {0, 20, 30 + g}}),
        test::polygon({{0, 0, 0}, {10, 0, 0}, {10, 0, 30}, {0, 0, 30}}),
        test::polygon({{10 + g, 0, 0}, {10 + g, 20, 0}, {10 + g, 20, 30}, {10 + g, 0, 30}}),
        test::polygon({{10, 20 + g, 0}, {0, 20 + g, 0}, {0, 20 + g, 30}, {10, 20 + g, 30}}),
        test::polygon({{-g, 20, 0}, {-g, 0, 0}, {-g, 0, 30}, {-g, 20, 30}}),
    });
}

TEST(SewShape, ClosesTheLooseFacesOfASolidOutwards) {
    const TopoDS_Shape box = BRepPrimAPI_MakeBox(10.0, 20.0, 30.0).Shape();
    for (const double scale : {1e-3, 1.0, 1e3}) {
        const TopoDS_Shape whole = test::moved(box, scale);
        const SewnShape sewn = sew(test::loosened(whole));
        expect_sewn_as(whole, sewn);
        EXPECT_EQ(sewn.loose_faces, 6);
        EXPECT_EQ(sewn.free_edges_before, 24);
        EXPECT_EQ(sewn.replaced.Extent(), 6);
    }
}

TEST(SewShape, MakesASolidOfAShellThatCloses) {
    const TopoDS_Shape box = BRepPrimAPI_MakeBox(10.0, 20.0, 30.0).Shape();
    const SewnShape one = sew(test::loosened(box));
    ASSERT_EQ(one.shape.ShapeType(), TopAbs_SOLID);
    EXPECT_TRUE(BRepCheck_Analyzer(one.shape).IsValid());

    gp_Trsf aside;
    aside.SetTranslation(gp_Vec(50.0, 0.0, 0.0));
    const TopoDS_Shape open = test::without_faces(box.Moved(TopLoc_Location(aside)), {1});
    const SewnShape two = sew(test::compound_of({test::loosened(box), test::loosened(open)}));
    TopTools_IndexedMapOfShape solids;
    TopExp::MapShapes(two.shape, TopAbs_SOLID, solids);
    ASSERT_EQ(solids.Extent(), 1);
    EXPECT_NEAR(volume(solids(1)), 6000.0, 1e-6);
    EXPECT_EQ(census(two.shape), (Census{{"hole", 4}}));
}

TEST(SewShape, TurnsFacesToAgreeAndTheShellOutwards) {
    const TopoDS_Shape box = BRepPrimAPI_MakeBox(10.0, 20.0, 30.0).Shape();
    std::vector<TopoDS_Shape> parts;
    int i = 0;
    for (const TopoDS_Face& face : occ::faces_of(test::loosened(box))) {
        parts.push_back(i++ % 3 == 0 ? TopoDS_Shape(face) : face.Reversed());
    }
    const SewnShape sewn = sew(test::compound_of(parts));
    expect_sewn_as(box, sewn);
    const ShellGraph graph = make_shell_graph(sewn.shape);
    for (const Coedge& use : graph.uses) {
        EXPECT_NE(use.edge.Orientation(), graph.uses[use.mate].edge.Orientation());
    }
}

TEST(SewShape, ClosesGapsThatAreSmallAgainstTheirEdges) {
    const SewnShape sewn = sew(box_with_gaps(0.004));
    EXPECT_EQ(sewn.free_edges_after, 0);
    EXPECT_GE(sewn.largest_gap, 0.004);
    EXPECT_LE(sewn.largest_gap, 0.004 * std::sqrt(3.0));
    EXPECT_GE(sewn.tolerance, sewn.largest_gap);
}

TEST(SewShape, LeavesGapsThatAreLargeAgainstTheirEdges) {
    const SewnShape sewn = sew(box_with_gaps(0.3));
    EXPECT_GT(sewn.free_edges_after, 0);
    EXPECT_LT(sewn.tolerance, 0.1);
}

TEST(SewShape, TakesTheGivenTolerance) {
    const SewnShape sewn = sew(box_with_gaps(0.3), 0.7);
    EXPECT_EQ(sewn.free_edges_after, 0);
    EXPECT_EQ(sewn.tolerance, 0.7);
}

TEST(SewShape, KeepsAThinSlotInAPlate) {
    const TopoDS_Shape plate = BRepPrimAPI_MakeBox(100.0, 90.0, 5.0).Shape();
    const TopoDS_Shape tool =
        BRepPrimAPI_MakeBox(gp_Pnt(10, 44.95, -1), gp_Pnt(90, 45.05, 6)).Shape();
    const TopoDS_Shape slotted = BRepAlgoAPI_Cut(plate, tool).Shape();
    expect_sewn_as(slotted, sew(test::loosened(slotted)));
}

TEST(SewShape, KeepsASlotInALoneSheet) {
    test::PolygonMesh mesh({{0, 0, 0},
                            {100, 0, 0},
                            {100, 90, 0},
                            {0, 90, 0},
                            {10, 44.95, 0},
                            {90, 44.95, 0},
                            {90, 45.05, 0},
                            {10, 45.05, 0}});
    const TopoDS_Face sheet = mesh.face({{0, 1, 2, 3}, {4, 7, 6, 5}});
    const SewnShape sewn = sew(test::compound_of({sheet}));
    EXPECT_FALSE(sewn.changed);
    EXPECT_EQ(census(sewn.shape), (Census{{"rim", 4}, {"hole", 4}}));
}

TEST(SewShape, KeepsANarrowSlotBetweenTwoFaces) {
    // a sheet in two halves that meet left and right of a slot 0.1 wide and 80 long
    const TopoDS_Face lower = test::polygon({{0, 0, 0},
                                             {100, 0, 0},
                                             {100, 45, 0},
                                             {90, 45, 0},
                                             {90, 44.95, 0},
                                             {10, 44.95, 0},
                                             {10, 45, 0},
                                             {0, 45, 0}});
    const TopoDS_Face upper = test::polygon({{0, 45, 0},
                                             {10, 45, 0},
                                             {10, 45.05, 0},
                                             {90, 45.05, 0},
                                             {90, 45, 0},
                                             {100, 45, 0},
                                             {100, 90, 0},
                                             {0, 90, 0}});
    const SewnShape sewn = sew(test::compound_of({lower, upper}));
    EXPECT_EQ(sewn.free_edges_before - sewn.free_edges_after, 4);
    EXPECT_LT(sewn.tolerance, 0.05);
}

/// Two sheets with a gap of 0.08 along an edge of 100 between them.
std::vector<TopoDS_Shape> sheets_with_gap() {
    return {test::polygon({{0, 0, 0}, {100, 0, 0}, {100, 45, 0}, {0, 45, 0}}),
            test::polygon({{0, 45.08, 0}, {100, 45.08, 0}, {100, 90, 0}, {0, 90, 0}})};
}

TEST(SewShape, ClosesAGapThatNoFeatureForbids) {
    const SewnShape sewn = sew(test::compound_of(sheets_with_gap()));
    EXPECT_EQ(sewn.free_edges_after, 6);
    EXPECT_NEAR(sewn.largest_gap, 0.08, 1e-9);
}

TEST(SewShape, StaysBelowTheNarrowestSliver) {
    const TopoDS_Vertex a = BRepBuilderAPI_MakeVertex(gp_Pnt(0, -50, 0));
    const TopoDS_Vertex b = BRepBuilderAPI_MakeVertex(gp_Pnt(100, -50, 0));
    const occ::Handle<Geom_TrimmedCurve> arc =
        GC_MakeArcOfCircle(gp_Pnt(0, -50, 0), gp_Pnt(50, -50.1, 0), gp_Pnt(100, -50, 0)).Value();
    const TopoDS_Face sliver =
        BRepBuilderAPI_MakeFace(BRepBuilderAPI_MakeWire(BRepBuilderAPI_MakeEdge(arc, a, b).Edge(),
                                                        BRepBuilderAPI_MakeEdge(b, a).Edge())
                                    .Wire());
    std::vector<TopoDS_Shape> parts = sheets_with_gap();
    parts.push_back(sliver);
    const SewnShape sewn = sew(test::compound_of(parts));
    EXPECT_LE(sewn.tolerance, 0.1 / 4.0);
    EXPECT_FALSE(sewn.changed);
}

TEST(SewShape, StaysBelowTheShortestEdge) {
    std::vector<TopoDS_Shape> parts = sheets_with_gap();
    const TopoDS_Edge pinprick =
        BRepBuilderAPI_MakeEdge(gp_Circ(gp_Ax2(gp_Pnt(20, 20, 0), gp_Dir(0, 0, -1)), 0.01));
    parts[0] =
        BRepBuilderAPI_MakeFace(TopoDS::Face(parts[0]), BRepBuilderAPI_MakeWire(pinprick).Wire())
            .Face();
    const SewnShape sewn = sew(test::compound_of(parts));
    EXPECT_LE(sewn.tolerance, 2.0 * kPi * 0.01 / 4.0 * 1.01);
    EXPECT_FALSE(sewn.changed);
}

TEST(MakeShells, TurnsFacesThatDisagree) {
    const TopoDS_Shape box = BRepPrimAPI_MakeBox(10.0, 20.0, 30.0).Shape();
    std::vector<TopoDS_Face> faces = occ::faces_of(box);
    for (const int turned : {0, 2, 3, 5}) {
        faces[turned] = TopoDS::Face(faces[turned].Reversed());
    }
    const auto shells = make_shells(faces, std::vector<int>(faces.size(), -1));
    ASSERT_EQ(shells.size(), 1U);
    EXPECT_NEAR(volume(shells.front().shell), 6000.0, 1e-6);
    EXPECT_EQ(shells.front().members.size(), 6U);
}

TEST(SewShape, KeepsANarrowHoleOfASolid) {
    const TopoDS_Shape box = BRepPrimAPI_MakeBox(40.0, 30.0, 20.0).Shape();
    const TopoDS_Shape tool = BRepPrimAPI_MakeBox(gp_Pnt(5, 10, 15), gp_Pnt(30, 10.5, 21)).Shape();
    const TopoDS_Shape pocketed = BRepAlgoAPI_Cut(box, tool).Shape();
    const std::vector<TopoDS_Face> faces = occ::faces_of(pocketed);
    std::vector<TopoDS_Shape> outside;  // without the pocket's walls and bottom
    for (const TopoDS_Face& face : faces) {
        GProp_GProps properties;
        BRepGProp::SurfaceProperties(face, properties);
        const gp_Pnt c = properties.CentreOfMass();
        const bool inner = c.Z() > 14.9 && c.Z() < 19.9 && c.X() > 4.9 && c.X() < 30.1 &&
                           c.Y() > 9.9 && c.Y() < 10.6;
        if (!inner) {
            outside.push_back(face);
        }
    }
    ASSERT_EQ(outside.size(), 6U);
    const SewnShape sewn = sew(test::loosened(test::compound_of(outside)));
    EXPECT_EQ(census(sewn.shape), (Census{{"hole", 4}}));
}

TEST(SewShape, KeepsTheWallsOfAThinPlateApart) {
    const TopoDS_Shape plate = BRepPrimAPI_MakeBox(100.0, 80.0, 0.1).Shape();
    expect_sewn_as(plate, sew(test::loosened(plate)));
}

TEST(SewShape, ClosesAFaceOnItselfAndToItsLids) {
    const TopoDS_Shape cylinder = BRepPrimAPI_MakeCylinder(2.0, 5.0).Shape();
    expect_sewn_as(cylinder, sew(test::loosened(cylinder)));
}

TEST(SewShape, LeavesConnectedShellsUntouched) {
    const TopoDS_Shell open =
        test::without_faces(BRepPrimAPI_MakeBox(10.0, 20.0, 30.0).Shape(), {1});
    gp_Trsf aside;
    aside.SetTranslation(gp_Vec(50.0, 0.0, 0.0));
    const TopoDS_Compound loose =
        test::loosened(BRepPrimAPI_MakeBox(10.0, 20.0, 30.0).Shape().Moved(TopLoc_Location(aside)));
    const SewnShape sewn = sew(test::compound_of({open, loose}));
    EXPECT_TRUE(sewn.changed);
    EXPECT_EQ(census(sewn.shape), (Census{{"hole", 4}}));
    TopTools_IndexedMapOfShape shells;
    TopExp::MapShapes(sewn.shape, TopAbs_SHELL, shells);
    EXPECT_TRUE(shells.Contains(open));
    EXPECT_EQ(shells.Extent(), 2);
}

TEST(SewShape, GivesBackWhatHasNoLooseFaces) {
    const TopoDS_Shape box = BRepPrimAPI_MakeBox(10.0, 20.0, 30.0).Shape();
    const SewnShape sewn = sew(box);
    EXPECT_FALSE(sewn.changed);
    EXPECT_TRUE(sewn.shape.IsEqual(box));
    EXPECT_EQ(sewn.loose_faces, 0);
}

TEST(SewShape, SewsTheFacesOfEachCompoundByThemselves) {
    const TopoDS_Shape left = BRepPrimAPI_MakeBox(gp_Pnt(0, 0, 0), gp_Pnt(4, 3, 2)).Shape();
    const TopoDS_Shape right = BRepPrimAPI_MakeBox(gp_Pnt(4, 0, 0), gp_Pnt(9, 3, 2)).Shape();
    const SewnShape sewn = sew(test::compound_of({test::loosened(left), test::loosened(right)}));
    EXPECT_EQ(sewn.free_edges_after, 0);
    TopTools_IndexedMapOfShape shells;
    TopExp::MapShapes(sewn.shape, TopAbs_SHELL, shells);
    EXPECT_EQ(shells.Extent(), 2);
    EXPECT_NEAR(volume(sewn.shape), 9.0 * 3.0 * 2.0, 1e-9);
}

TEST(SewShape, LeavesASheetThatDividesABodyOutOfIt) {
    // two boxes as one, the wall between them drawn once: a body of ten faces and a sheet
    std::vector<TopoDS_Shape> parts;
    for (const double x : {0.0, 4.0}) {
        const TopoDS_Shape half = BRepPrimAPI_MakeBox(gp_Pnt(x, 0, 0), gp_Pnt(x + 4, 3, 2)).Shape();
        for (const TopoDS_Face& face : occ::faces_of(test::loosened(half))) {
            GProp_GProps properties;
            BRepGProp::SurfaceProperties(face, properties);
            if (std::abs(properties.CentreOfMass().X() - 4.0) > 1e-9 || x == 0.0) {
                parts.push_back(face);
            }
        }
    }
    ASSERT_EQ(parts.size(), 11U);
    for (int turn = 0; turn < 11; ++turn) {
        std::rotate(parts.begin(), parts.begin() + 1, parts.end());
        const SewnShape sewn = sew(test::compound_of(parts));
        EXPECT_EQ(sewn.free_edges_after, 4);
        EXPECT_EQ(census(sewn.shape), (Census{{"rim", 4}}));
    }
}

TEST(SewShape, SewsAcrossCompoundsWhatIsStillOpen) {
    const TopoDS_Shape box = BRepPrimAPI_MakeBox(10.0, 20.0, 30.0).Shape();
    const std::vector<TopoDS_Face> faces = occ::faces_of(test::loosened(box));
    const SewnShape sewn =
        sew(test::compound_of({test::compound_of({faces[0], faces[1], faces[2]}),
                               test::compound_of({faces[3], faces[4], faces[5]})}));
    expect_sewn_as(box, sewn);
}

TEST(SewShape, RefusesImpossibleTolerances) {
    const TopoDS_Shape box = BRepPrimAPI_MakeBox(1.0, 2.0, 3.0).Shape();
    for (const double tolerance : {-1.0, std::numeric_limits<double>::quiet_NaN(),
                                   std::numeric_limits<double>::infinity()}) {
        const auto result = sew_shape(box, tolerance);
        ASSERT_FALSE(result.has_value());
        EXPECT_EQ(result.error().code, ErrorCode::Usage);
    }
    EXPECT_FALSE(sew_shape(TopoDS_Shape(), 0.0).has_value());
}

}  // namespace
}  // namespace suture

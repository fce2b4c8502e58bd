#include "suture/detect/find_loops.h"

#include "suture/base/tolerance.h"

#include "kernel/detect/shapes.h"
#include <gmock/gmock.h>

#include <BRepFilletAPI_MakeFillet.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <TopoDS_Solid.hxx>

#include <algorithm>

namespace suture {
namespace {

using test::Census;
using test::census;
using test::loops_of;
using test::PolygonMesh;
using testing::HasSubstr;

TopoDS_Shape filleted_box() {
    const TopoDS_Shape box = BRepPrimAPI_MakeBox(30.0, 40.0, 50.0).Shape();
    BRepFilletAPI_MakeFillet fillet(box);
    for (const TopoDS_Edge& edge : occ::edges_of(box)) {
        fillet.Add(4.0, edge);
    }
    return fillet.Shape();
}

/// The number of the first face with this many edges.
int face_with_edges(const TopoDS_Shape& shape, std::size_t edges) {
    const std::vector<TopoDS_Face> faces = occ::faces_of(shape);
    for (std::size_t i = 0; i < faces.size(); ++i) {
        std::size_t count = 0;
        for (const TopoDS_Edge& edge : occ::edges_of(faces[i])) {
            count += BRep_Tool::Degenerated(edge) ? 0 : 1;
        }
        if (count == edges) {
            return static_cast<int>(i) + 1;
        }
    }
    ADD_FAILURE() << "no face has " << edges << " edges";
    return 0;
}

/// A square pyramid on 0, 1, 2, 3 with apex 4; faces: base, then the sides 0-1, 1-2, 2-3, 3-0.
std::vector<TopoDS_Face> pyramid(double height) {
    PolygonMesh mesh({{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}, {0, 0, height}});
    return {mesh.face({3, 2, 1, 0}), mesh.face({0, 1, 4}), mesh.face({1, 2, 4}),
            mesh.face({2, 3, 4}), mesh.face({3, 0, 4})};
}

TEST(FindLoops, FindsNoneInClosedSolids) {
    const std::vector<TopoDS_Shape> solids{
        BRepPrimAPI_MakeBox(1.0, 2.0, 3.0).Shape(),  BRepPrimAPI_MakeCylinder(2.0, 5.0).Shape(),
        BRepPrimAPI_MakeSphere(3.0).Shape(),         BRepPrimAPI_MakeTorus(5.0, 1.0).Shape(),
        BRepPrimAPI_MakeCone(2.0, 0.0, 4.0).Shape(), filleted_box()};
    for (const TopoDS_Shape& solid : solids) {
        EXPECT_TRUE(loops_of(solid).empty());
    }
}

TEST(FindLoops, FindsTheMissingFaceOfASolidWithItsSides) {
    const TopoDS_Shape box = BRepPrimAPI_MakeBox(10.0, 20.0, 30.0).Shape();
    for (int face = 1; face <= 6; ++face) {
        const auto loops = loops_of(test::without_faces(box, {face}));
        EXPECT_EQ(census(loops), (Census{{"hole", 4}})) << "without face " << face;
        test::expect_well_walked(loops.front());
        EXPECT_TRUE(loops.front().planar);
        EXPECT_EQ(loops.front().shell_faces, 5);
    }
    const TopoDS_Shape rounded = filleted_box();
    EXPECT_EQ(census(test::without_faces(rounded, {face_with_edges(rounded, 3)})),
              (Census{{"hole", 3}}));
    EXPECT_EQ(census(test::without_faces(rounded, {face_with_edges(rounded, 4)})),
              (Census{{"hole", 4}}));
}

TEST(FindLoops, MeasuresLengthAndDiameterOfASingleClosedEdge) {
    const TopoDS_Shape cylinder = BRepPrimAPI_MakeCylinder(2.0, 5.0).Shape();
    const auto loops = loops_of(test::without_faces(cylinder, {face_with_edges(cylinder, 1)}));
    ASSERT_EQ(census(loops), (Census{{"hole", 1}}));
    EXPECT_NEAR(loops.front().length, 4.0 * kPi, 1e-9);
    EXPECT_NEAR(loops.front().diameter, 4.0 * std::sqrt(2.0), 1e-2);
    EXPECT_TRUE(loops.front().planar);
    test::expect_well_walked(loops.front());
}

TEST(FindLoops, WalksWithTheHoleOnTheLeft) {
    const TopoDS_Shape box = BRepPrimAPI_MakeBox(10.0, 20.0, 30.0).Shape();
    const auto loops = loops_of(test::without_faces(box, {6}));  // the top, z = 30
    ASSERT_EQ(loops.size(), 1U);
    double doubled_area = 0.0;  // seen from above
    for (const BoundaryEdge& edge : loops.front().edges) {
        const gp_Pnt a = BRep_Tool::Pnt(TopExp::FirstVertex(edge.edge, true));
        const gp_Pnt b = BRep_Tool::Pnt(TopExp::LastVertex(edge.edge, true));
        ASSERT_NEAR(a.Z(), 30.0, 1e-12);
        doubled_area += a.X() * b.Y() - b.X() * a.Y();
    }
    EXPECT_NEAR(doubled_area, 2.0 * 10.0 * 20.0, 1e-9);
}

TEST(FindLoops, GivesTwoLoopsWhereHolesTouchInAVertexOfABody) {
    std::vector<TopoDS_Face> faces = pyramid(1.5);
    faces.erase(faces.begin() + 3);
    faces.erase(faces.begin() + 1);
    const auto loops = loops_of(test::shell_of(faces));
    EXPECT_EQ(census(loops), (Census{{"hole", 3}, {"hole", 3}}));
    for (const BoundaryLoop& loop : loops) {
        test::expect_well_walked(loop);
    }
}

TEST(FindLoops, GivesTwoLoopsWhereHolesTouchInAPlaceWithTwoVertices) {
    PolygonMesh mesh({{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}, {0, 0, 1.5}, {0, 0, 1.5}});
    const TopoDS_Shell open =
        test::shell_of({mesh.face({3, 2, 1, 0}), mesh.face({1, 2, 4}), mesh.face({3, 0, 5})});
    for (const TopoDS_Shape& shape : {TopoDS_Shape(open), open.Reversed(), test::renumbered(open),
                                      test::moved(open, 1e3), test::moved(open, 1e-2)}) {
        const auto loops = loops_of(shape);
        ASSERT_EQ(census(loops), (Census{{"hole", 3}, {"hole", 3}}));
        for (const BoundaryLoop& loop : loops) {
            test::expect_well_walked(loop);
        }
    }
}

TEST(FindLoops, DoesNotCutACrackWhereItsSidesHaveVerticesInOnePlace) {
    PolygonMesh mesh({{-3, 0, 0},
                      {-2, 0, 0},
                      {0, 0, 0},
                      {0, 0, 0},
                      {2, 0, 0},
                      {3, 0, 0},
                      {3, -2, 0},
                      {-3, -2, 0},
                      {3, 2, 0},
                      {-3, 2, 0}});
    const auto loops = loops_of(
        test::shell_of({mesh.face({7, 6, 5, 4, 2, 1, 0}), mesh.face({0, 1, 3, 4, 5, 8, 9})}));
    EXPECT_EQ(census(loops), (Census{{"rim", 6}, {"seam", 4}}));
}

TEST(FindLoops, DoesNotCutOffAnEdgeThatIsShorterThanItsTolerance) {
    PolygonMesh mesh({{0, 0, 0},
                      {9, 0, 0},
                      {9, 5, 0},
                      {0, 5, 0},
                      {1, 1, 0},
                      {2, 1, 0},
                      {2, 1.001, 0},
                      {1, 2, 0}});
    TopoDS_Shell sheet = test::shell_of({mesh.face({{0, 1, 2, 3}, {4, 7, 6, 5}})});
    for (TopExp_Explorer it(sheet, TopAbs_VERTEX); it.More(); it.Next()) {
        BRep_Builder().UpdateVertex(TopoDS::Vertex(it.Current()), 0.002);
    }
    EXPECT_EQ(census(sheet), (Census{{"rim", 4}, {"hole", 4}}));
}

TEST(FindLoops, GivesTwoLoopsWhereHolesTouchInAVertexOfOneFace) {
    PolygonMesh mesh({{-9, -5, 0},
                      {9, -5, 0},
                      {9, 5, 0},
                      {-9, 5, 0},  // the sheet
                      {0, 0, 0},
                      {3, -1, 0},
                      {3, 1, 0},
                      {-3, 1, 0},
                      {-3, -1, 0}});
    const auto loops = loops_of(test::shell_of({mesh.face({{0, 1, 2, 3}, {4, 6, 5}, {4, 8, 7}})}));
    EXPECT_EQ(census(loops), (Census{{"rim", 4}, {"hole", 3}, {"hole", 3}}));
}

TEST(FindLoops, TellsTheRimOfASheetFromItsHoles) {
    PolygonMesh mesh({{0, 0, 0},
                      {9, 0, 0},
                      {9, 5, 0},
                      {0, 5, 0},
                      {1, 1, 0},
                      {2, 1, 0},
                      {1, 2, 0},
                      {5, 1, 0},
                      {8, 1, 0},
                      {8, 4, 0},
                      {5, 4, 0}});
    const auto loops =
        loops_of(test::shell_of({mesh.face({{0, 1, 2, 3}, {4, 6, 5}, {7, 10, 9, 8}})}));
    EXPECT_EQ(census(loops), (Census{{"rim", 4}, {"hole", 3}, {"hole", 4}}));
    EXPECT_TRUE(std::all_of(loops.begin(), loops.end(), [](const BoundaryLoop& loop) {
        return loop.islands_with.empty() && !loop.reason.empty();
    }));
}

TEST(FindLoops, CallsDuctEndsHoles) {
    const TopoDS_Shape cylinder = BRepPrimAPI_MakeCylinder(2.0, 5.0).Shape();
    const auto loops = loops_of(test::without_faces(cylinder, {2, 3}));
    EXPECT_EQ(census(loops), (Census{{"hole", 1}, {"hole", 1}}));
    EXPECT_TRUE(loops[0].islands_with.empty());
}

TEST(FindLoops, LetsTheAreaDecideOnPyramidsWithoutBase) {
    const auto kind = [](double height) {
        std::vector<TopoDS_Face> faces = pyramid(height);
        faces.erase(faces.begin());
        return census(test::shell_of(faces));
    };
    EXPECT_EQ(kind(0.05), (Census{{"rim", 4}}));
    EXPECT_EQ(kind(2.5), (Census{{"hole", 4}}));
}

TEST(FindLoops, CallsACapAboveTheEquatorARimAndBelowItAHole) {
    const auto cap = [](double from) {
        const TopoDS_Shape sphere = BRepPrimAPI_MakeSphere(gp_Ax2(), 3.0, from, 0.5 * kPi).Shape();
        return census(test::without_faces(sphere, {face_with_edges(sphere, 1)}));
    };
    // the sphere's own face has its seam besides the circle
    EXPECT_EQ(cap(radians(60.0)), (Census{{"rim", 1}}));
    // The shell turns 360 deg sin(latitude): 90 and 180 are the limits of what turning alone tells,
    // where the cap's area is less than twice that of its opening.
    for (const auto& [turning, kind] : std::vector<std::pair<double, std::string>>{
             {80.0, "hole"}, {100.0, "ambiguous"}, {170.0, "ambiguous"}, {190.0, "rim"}}) {
        EXPECT_EQ(cap(std::asin(turning / 360.0)), (Census{{kind, 1}})) << turning;
    }
    EXPECT_EQ(cap(radians(-60.0)), (Census{{"hole", 1}}));
    EXPECT_EQ(cap(0.0), (Census{{"hole", 1}}));
}

TEST(FindLoops, WalksAMoebiusBandAndSaysSo) {
    constexpr int kBays = 9;
    std::vector<gp_Pnt> points;
    for (int i = 0; i < kBays; ++i) {
        const double a = 2.0 * kPi * i / kBays;
        for (const double side : {-1.0, 1.0}) {
            const double r = 5.0 + side * std::cos(0.5 * a);
            points.emplace_back(r * std::cos(a), r * std::sin(a), side * std::sin(0.5 * a));
        }
    }
    PolygonMesh mesh(points);
    std::vector<TopoDS_Face> faces;
    for (int i = 0; i < kBays; ++i) {
        const bool last = i == kBays - 1;
        const int a = 2 * i;
        const int b = 2 * i + 1;
        const int c = last ? 1 : 2 * i + 2;  // the band closes with a half turn
        const int d = last ? 0 : 2 * i + 3;
        faces.push_back(mesh.face({a, c, d}));
        faces.push_back(mesh.face({a, d, b}));
    }
    const auto loops = loops_of(test::shell_of(faces));
    ASSERT_EQ(census(loops), (Census{{"ambiguous", 2 * kBays}}));
    EXPECT_THAT(loops.front().reason, HasSubstr("one side"));
}

TEST(FindLoops, FindsTheLoopsOfEachShellOfACompound) {
    const TopoDS_Shell open = test::without_faces(BRepPrimAPI_MakeBox(1.0, 2.0, 3.0).Shape(), {1});
    gp_Trsf aside;
    aside.SetTranslation(gp_Vec(10.0, 0.0, 0.0));
    const TopoDS_Compound twice = test::compound_of(
        {open, open.Moved(TopLoc_Location(aside)), BRepPrimAPI_MakeSphere(1.0).Shape()});
    const auto loops = loops_of(twice);
    ASSERT_EQ(census(loops), (Census{{"hole", 4}, {"hole", 4}}));
    EXPECT_EQ(loops[0].id, 1);
    EXPECT_EQ(loops[1].id, 2);
    EXPECT_LT(loops[0].edges.front().edge_number, loops[1].edges.front().edge_number);
}

TEST(FindLoops, WalksThroughFacesThatTheFileTurnsOver) {
    std::vector<TopoDS_Face> faces = pyramid(2.5);
    faces.erase(faces.begin());
    faces[1] = TopoDS::Face(faces[1].Reversed());
    const auto loops = loops_of(test::shell_of(faces));
    ASSERT_EQ(census(loops), (Census{{"hole", 4}}));
    test::expect_well_walked(loops.front());
    EXPECT_THAT(loops.front().reason, HasSubstr("turns the faces of 1 of its edges"));
}

TEST(FindLoops, TakesNoEdgeOfThreeFacesForAFreeOne) {
    PolygonMesh mesh(
        {{0, 0, 0}, {4, 0, 0}, {4, 3, 0}, {0, 3, 0}, {4, -3, 0}, {0, -3, 0}, {4, 0, 2}, {0, 0, 2}});
    const TopoDS_Shell shell =
        test::shell_of({mesh.face({0, 1, 2, 3}), mesh.face({5, 4, 1, 0}), mesh.face({0, 1, 6, 7})});
    const auto loops = loops_of(shell);
    const Census expected{{"rim", 6}, {"ambiguous", 4}};
    EXPECT_EQ(census(loops), expected);
}

TEST(FindLoops, LooksAtEachShellByItselfWhereTwoHaveAnEdge) {
    for (const bool first_is_open : {true, false}) {
        for (std::size_t missing = 0; missing < 6; ++missing) {
            const auto loops = loops_of(test::boxes_with_common_edge(first_is_open, missing));
            ASSERT_EQ(census(loops), (Census{{"hole", 4}})) << missing;
            test::expect_well_walked(loops.front());
            EXPECT_EQ(loops.front().shell_faces, 5);
        }
    }
}

TEST(FindLoops, TakesEveryLoopOfASolidForAHole) {
    // one half of a lens is a sheet, unless the file says that it bounds a solid
    const TopoDS_Shell cap = test::without_faces(
        BRepPrimAPI_MakeSphere(gp_Ax2(gp_Pnt(0, 0, 0), gp_Dir(0, 0, 1)), 10.0, kPi / 4, kPi / 2)
            .Shape(),
        {2});
    EXPECT_EQ(census(cap), (Census{{"rim", 1}}));
    BRep_Builder builder;
    TopoDS_Solid solid;
    builder.MakeSolid(solid);
    builder.Add(solid, cap);
    EXPECT_EQ(census(solid), (Census{{"hole", 1}}));
}

TEST(FindLoops, GoesOverAnEdgeThatIsShorterThanItsTolerance) {
    // a strip one of whose corners is cut off; its vertices may lie anywhere around there
    for (const double inside : {1e-3, -1e-3}) {
        BRep_Builder builder;
        const TopoDS_Face strip =
            test::polygon({{0, 0, 0}, {50, 0, 0}, {50, 3, 0}, {0.001, 3 - inside, 0}, {0, 3, 0}});
        for (TopExp_Explorer it(strip, TopAbs_VERTEX); it.More(); it.Next()) {
            const TopoDS_Vertex vertex = TopoDS::Vertex(it.Current());
            if (BRep_Tool::Pnt(vertex).X() < 1.0 && BRep_Tool::Pnt(vertex).Y() > 1.0) {
                builder.UpdateVertex(vertex, 0.005);
            }
        }
        EXPECT_EQ(census(strip), (Census{{"rim", 5}}));
    }
}

TEST(FindLoops, TakesInternalEdgesAndSeamsForNoFreeOnes) {
    PolygonMesh mesh({{0, 0, 0}, {4, 0, 0}, {4, 3, 0}, {0, 3, 0}, {1, 1, 0}, {3, 2, 0}});
    const TopoDS_Face face = mesh.face({0, 1, 2, 3});
    BRep_Builder builder;
    TopoDS_Wire inner;
    builder.MakeWire(inner);
    builder.Add(
        inner,
        BRepBuilderAPI_MakeEdge(gp_Pnt(1, 1, 0), gp_Pnt(3, 2, 0)).Edge().Oriented(TopAbs_INTERNAL));
    const TopoDS_Shape copy = face.EmptyCopied();
    TopoDS_Face scored = TopoDS::Face(copy);
    for (TopExp_Explorer it(face, TopAbs_WIRE); it.More(); it.Next()) {
        builder.Add(scored, it.Current());
    }
    builder.Add(scored, inner);
    EXPECT_EQ(census(test::shell_of({scored})), (Census{{"rim", 4}}));
}

TEST(FindLoops, FillsNothingAlongHalfASeam) {
    const TopoDS_Shape cylinder = BRepPrimAPI_MakeCylinder(2.0, 5.0).Shape();
    const TopoDS_Face side = occ::faces_of(cylinder)[face_with_edges(cylinder, 3) - 1];
    BRep_Builder builder;
    TopoDS_Wire wire;
    builder.MakeWire(wire);
    bool seam_used = false;
    for (TopExp_Explorer it(side.Oriented(TopAbs_FORWARD), TopAbs_EDGE); it.More(); it.Next()) {
        const bool seam = BRep_Tool::IsClosed(TopoDS::Edge(it.Current()), side);
        if (!seam || !seam_used) {
            builder.Add(wire, it.Current());
        }
        seam_used = seam_used || seam;
    }
    const TopoDS_Shape copy = side.EmptyCopied();
    TopoDS_Face half = TopoDS::Face(copy);
    builder.Add(half, wire);
    int holes = 0;
    for (const BoundaryLoop& loop : loops_of(test::shell_of({half}))) {
        const bool circle = BRep_Tool::IsClosed(loop.edges.front().edge);
        EXPECT_EQ(loop.kind, circle ? LoopKind::Hole : LoopKind::Ambiguous) << loop.reason;
        holes += loop.kind == LoopKind::Hole ? 1 : 0;
    }
    EXPECT_EQ(holes, 2);
}

TEST(FindLoops, CallsTwoEdgesOnEachOtherInOneFaceASlit) {
    const TopoDS_Vertex a = BRepBuilderAPI_MakeVertex(gp_Pnt(1, 1, 0));
    const TopoDS_Vertex b = BRepBuilderAPI_MakeVertex(gp_Pnt(3, 2, 0));
    BRep_Builder builder;
    TopoDS_Wire slit;
    builder.MakeWire(slit);
    builder.Add(slit, BRepBuilderAPI_MakeEdge(a, b).Edge());
    builder.Add(slit, BRepBuilderAPI_MakeEdge(b, a).Edge());
    TopoDS_Face sheet = test::polygon({{0, 0, 0}, {4, 0, 0}, {4, 3, 0}, {0, 3, 0}});
    builder.Add(sheet, slit);
    EXPECT_EQ(census(test::shell_of({sheet})), (Census{{"rim", 4}, {"slit", 2}}));
}

TEST(FindLoops, CallsLoopsOnEachOtherSeams) {
    // two boxes on top of each other, both without the face between them
    const TopoDS_Shape lower = BRepPrimAPI_MakeBox(gp_Pnt(0, 0, 0), gp_Pnt(4, 3, 2)).Shape();
    const TopoDS_Shape upper = BRepPrimAPI_MakeBox(gp_Pnt(0, 0, 2.001), gp_Pnt(4, 3, 5)).Shape();
    const auto loops = loops_of(
        test::compound_of({test::without_faces(lower, {6}), test::without_faces(upper, {5})}));
    ASSERT_EQ(census(loops), (Census{{"seam", 4}, {"seam", 4}}));
    EXPECT_NEAR(loops.front().gap, 0.001, 1e-9);
}

// A box whose lid is in two halves, this far apart: nearer than what is a seam by its length, but
// with ends that are no longer than the gap.
TEST(FindLoops, CallsAHoleWithShortEndsAHoleHoweverNarrow) {
    for (const double gap : {0.02, 0.05, 0.15}) {
        const double y = 0.5 * gap;
        PolygonMesh mesh({{0, -40, 0},
                          {100, -40, 0},
                          {100, 40, 0},
                          {0, 40, 0},
                          {0, -40, 20},
                          {100, -40, 20},
                          {100, -y, 20},
                          {100, y, 20},
                          {100, 40, 20},
                          {0, 40, 20},
                          {0, y, 20},
                          {0, -y, 20}});
        const TopoDS_Shell box = test::shell_of(
            {mesh.face({0, 3, 2, 1}), mesh.face({0, 1, 5, 4}), mesh.face({2, 3, 9, 8}),
             mesh.face({1, 2, 8, 7, 6, 5}), mesh.face({3, 0, 4, 11, 10, 9}),
             mesh.face({4, 5, 6, 11}), mesh.face({10, 7, 8, 9})});
        for (const double scale : {1e-3, 1.0, 1e3}) {
            EXPECT_EQ(census(test::moved(box, scale)), (Census{{"hole", 4}})) << gap;
        }
    }
}

TEST(FindLoops, KeepsTheWallsOfAThinOpenPlateApart) {
    const TopoDS_Shape plate = BRepPrimAPI_MakeBox(100.0, 80.0, 0.1).Shape();
    EXPECT_EQ(census(test::without_faces(plate, {1, 2, 3, 4})), (Census{{"rim", 4}, {"rim", 4}}));
}

TEST(FindLoops, GivesTheSameForMovedScaledReversedAndRenumberedShapes) {
    const TopoDS_Shape rounded = filleted_box();
    const TopoDS_Shell open =
        test::without_faces(rounded, {face_with_edges(rounded, 3), face_with_edges(rounded, 4)});
    PolygonMesh mesh({{0, 0, 0}, {9, 0, 0}, {9, 5, 0}, {0, 5, 0}, {1, 1, 0}, {2, 1, 0}, {1, 2, 0}});
    const TopoDS_Shell sheet = test::shell_of({mesh.face({{0, 1, 2, 3}, {4, 6, 5}})});
    for (const TopoDS_Shape& shape : {TopoDS_Shape(open), TopoDS_Shape(sheet)}) {
        const Census expected = census(shape);
        ASSERT_FALSE(expected.empty());
        EXPECT_EQ(census(test::moved(shape, 1e-3)), expected);
        EXPECT_EQ(census(test::moved(shape, 1e3)), expected);
        EXPECT_EQ(census(shape.Reversed()), expected);
        EXPECT_EQ(census(test::renumbered(shape)), expected);
    }
}

TEST(FindLoops, RefusesANullShape) {
    const auto loops = find_loops(TopoDS_Shape(), occ::Numbering(BRepPrimAPI_MakeBox(1, 1, 1)));
    ASSERT_FALSE(loops.has_value());
    EXPECT_EQ(loops.error().code, ErrorCode::Usage);
}

}  // namespace
}  // namespace suture

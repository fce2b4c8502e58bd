#include "suture/base/tolerance.h"

#include "kernel/detect/shapes.h"

#include <BRepAdaptor_Surface.hxx>
#include <BRepAlgoAPI_Cut.hxx>
#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <TopoDS_Solid.hxx>

#include <functional>

namespace suture {
namespace {

using test::Census;
using test::census;
using test::loops_of;

TopoDS_Shape cylinder(double radius, double from, double to) {
    return BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(0, 0, from), gp_Dir(0, 0, 1)), radius, to - from)
        .Shape();
}

TopoDS_Shell without(const TopoDS_Shape& shape,
                     const std::function<bool(const BRepAdaptor_Surface&)>& unwanted) {
    std::set<int> numbers;
    const std::vector<TopoDS_Face> faces = occ::faces_of(shape);
    for (std::size_t i = 0; i < faces.size(); ++i) {
        if (unwanted(BRepAdaptor_Surface(faces[i]))) {
            numbers.insert(static_cast<int>(i) + 1);
        }
    }
    EXPECT_EQ(numbers.size(), 1U);
    return test::without_faces(shape, numbers);
}

bool is_plane_at(const BRepAdaptor_Surface& surface, double z) {
    return surface.GetType() == GeomAbs_Plane &&
           std::abs(surface.Plane().Axis().Direction().Z()) > 0.9 &&
           std::abs(surface.Plane().Location().Z() - z) < 1e-9;
}

bool is_cylinder_of(const BRepAdaptor_Surface& surface, double radius) {
    return surface.GetType() == GeomAbs_Cylinder &&
           std::abs(surface.Cylinder().Radius() - radius) < 1e-9;
}

void expect_one_face(const std::vector<BoundaryLoop>& loops) {
    ASSERT_EQ(loops.size(), 2U);
    EXPECT_EQ(loops[0].islands_with, std::vector<int>{2});
    EXPECT_EQ(loops[1].islands_with, std::vector<int>{1});
}

TEST(Islands, AreTheTwoCirclesOfAPipesMissingEndRing) {
    const TopoDS_Shape pipe = BRepAlgoAPI_Cut(cylinder(5, 0, 20), cylinder(3, -1, 21)).Shape();
    const auto loops =
        loops_of(without(pipe, [](const auto& surface) { return is_plane_at(surface, 20.0); }));
    EXPECT_EQ(census(loops), (Census{{"hole", 1}, {"hole", 1}}));
    expect_one_face(loops);
}

TEST(Islands, AreTheRimAndTheBoreOfABoxesMissingFace) {
    const TopoDS_Shape box = BRepPrimAPI_MakeBox(gp_Pnt(-8, -6, 0), gp_Pnt(8, 6, 10)).Shape();
    const TopoDS_Shape bored = BRepAlgoAPI_Cut(box, cylinder(3, -1, 11)).Shape();
    const TopoDS_Shell open =
        without(bored, [](const auto& surface) { return is_plane_at(surface, 10.0); });
    for (const TopoDS_Shape& shape :
         {TopoDS_Shape(open), open.Reversed(), test::moved(open, 1e3), test::moved(open, 1e-3)}) {
        const auto loops = loops_of(shape);
        EXPECT_EQ(census(loops), (Census{{"hole", 4}, {"hole", 1}}));
        expect_one_face(loops);
    }
}

TEST(Islands, AreNotTheTwoEndsOfAMissingBore) {
    const TopoDS_Shape box = BRepPrimAPI_MakeBox(gp_Pnt(-8, -6, 0), gp_Pnt(8, 6, 10)).Shape();
    const TopoDS_Shape bored = BRepAlgoAPI_Cut(box, cylinder(3, -1, 11)).Shape();
    const auto loops =
        loops_of(without(bored, [](const auto& surface) { return is_cylinder_of(surface, 3.0); }));
    EXPECT_EQ(census(loops), (Census{{"hole", 1}, {"hole", 1}}));
    EXPECT_TRUE(loops[0].islands_with.empty());
    EXPECT_TRUE(loops[1].islands_with.empty());
}

TEST(Islands, AreTheCirclesOfAMissingBandWhereDiscsWouldFoldBack) {
    const TopoDS_Shape stepped = BRepAlgoAPI_Fuse(cylinder(4, 0, 30), cylinder(9, 10, 16)).Shape();
    const TopoDS_Shape bored = BRepAlgoAPI_Cut(stepped, cylinder(2, -1, 31)).Shape();
    const auto loops =
        loops_of(without(bored, [](const auto& surface) { return is_cylinder_of(surface, 9.0); }));
    EXPECT_EQ(census(loops), (Census{{"hole", 1}, {"hole", 1}}));
    expect_one_face(loops);
}

TEST(Islands, AreNotTheEndsOfOneDuctInsideAnother) {
    const auto duct = [](double radius) {
        const TopoDS_Shape rod = cylinder(radius, 0, 20);
        std::vector<TopoDS_Face> side;
        for (const TopoDS_Face& face : occ::faces_of(rod)) {
            if (is_cylinder_of(BRepAdaptor_Surface(face), radius)) {
                side.push_back(face);
            }
        }
        return test::shell_of(side);
    };
    const auto loops = loops_of(test::compound_of({duct(5), duct(3)}));
    EXPECT_EQ(census(loops), (Census{{"hole", 1}, {"hole", 1}, {"hole", 1}, {"hole", 1}}));
    for (const BoundaryLoop& loop : loops) {
        EXPECT_TRUE(loop.islands_with.empty());
    }
}

TEST(Islands, AreOpenToDoubtBetweenTwoShells) {
    const auto loops = loops_of(without(
        cylinder(4, 0, 30), [](const auto& surface) { return is_cylinder_of(surface, 4.0); }));
    EXPECT_EQ(census(loops), (Census{{"ambiguous", 1}, {"ambiguous", 1}}));
    expect_one_face(loops);
}

TEST(Islands, AreNotTheRimOfASheetAndItsHole) {
    test::PolygonMesh mesh(
        {{0, 0, 0}, {9, 0, 0}, {9, 5, 0}, {0, 5, 0}, {1, 1, 0}, {2, 1, 0}, {1, 2, 0}});
    const auto loops = loops_of(test::shell_of({mesh.face({{0, 1, 2, 3}, {4, 6, 5}})}));
    EXPECT_EQ(census(loops), (Census{{"rim", 4}, {"hole", 3}}));
    EXPECT_TRUE(loops[0].islands_with.empty());
}

TEST(Islands, TakeInASheetThatLiesInTheHoleOfAnother) {
    test::PolygonMesh mesh({{0, 0, 0},
                            {9, 0, 0},
                            {9, 5, 0},
                            {0, 5, 0},
                            {1, 1, 0},
                            {8, 1, 0},
                            {8, 4, 0},
                            {1, 4, 0},
                            {3, 2, 0},
                            {6, 2, 0},
                            {5, 3, 0}});
    const auto loops = loops_of(
        test::compound_of({mesh.face({{0, 1, 2, 3}, {4, 7, 6, 5}}), mesh.face({8, 9, 10})}));
    EXPECT_EQ(census(loops), (Census{{"rim", 4}, {"hole", 4}, {"hole", 3}}));
    for (const BoundaryLoop& loop : loops) {
        EXPECT_EQ(loop.islands_with.size(), loop.kind == LoopKind::Hole ? 1U : 0U);
    }
}

/// A plate with a round hole of `hole` and a boss above it, whose wall begins at `from`.
TopoDS_Compound boss_without_fillet(double hole, double boss, double from) {
    const TopoDS_Shape plate = BRepPrimAPI_MakeBox(gp_Pnt(-30, -30, 0), gp_Pnt(30, 30, 10)).Shape();
    const TopoDS_Shape drilled = BRepAlgoAPI_Cut(plate, cylinder(hole, 5, 11)).Shape();
    std::set<int> inside;  // the bore, and its bottom
    const std::vector<TopoDS_Face> faces = occ::faces_of(drilled);
    for (std::size_t i = 0; i < faces.size(); ++i) {
        const BRepAdaptor_Surface surface(faces[i]);
        if (is_cylinder_of(surface, hole) || is_plane_at(surface, 5.0)) {
            inside.insert(static_cast<int>(i) + 1);
        }
    }
    EXPECT_EQ(inside.size(), 2U);
    return test::compound_of({test::without_faces(drilled, inside),
                              without(cylinder(boss, from, 30), [&](const auto& surface) {
                                  return is_plane_at(surface, from);
                              })});
}

TEST(Islands, AreTheTwoCirclesOfALostFillet) {
    for (const double scale : {1e-3, 1.0, 1e3}) {
        const auto loops = loops_of(test::moved(boss_without_fillet(16, 12, 14), scale));
        EXPECT_EQ(census(loops), (Census{{"hole", 1}, {"hole", 1}}));
        expect_one_face(loops);
    }
}

TEST(Islands, AreNoFilletWhereTheNeighboursMeetUnequallyFar) {
    for (const auto& loop : loops_of(boss_without_fillet(16, 12, 15))) {
        EXPECT_TRUE(loop.islands_with.empty());
    }
}

TEST(Islands, AreNoFilletBetweenTwoSolids) {
    BRep_Builder builder;
    std::vector<TopoDS_Shape> solids;
    for (TopExp_Explorer it(boss_without_fillet(16, 12, 14), TopAbs_SHELL); it.More(); it.Next()) {
        TopoDS_Solid solid;
        builder.MakeSolid(solid);
        builder.Add(solid, it.Current());
        solids.push_back(solid);
    }
    ASSERT_EQ(solids.size(), 2U);
    for (const auto& loop : loops_of(test::compound_of(solids))) {
        EXPECT_TRUE(loop.islands_with.empty());
    }
}

}  // namespace
}  // namespace suture

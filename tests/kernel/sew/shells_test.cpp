#include "support/properties.h"
#include "suture/occ/handle.h"
#include "suture/sew/sew_shape.h"

#include "kernel/detect/shapes.h"

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <TopoDS_Solid.hxx>

#include <cmath>

namespace suture {
namespace {

using test::Census;
using test::census;
using test::volume;

SewnShape sew(const TopoDS_Shape& shape, double tolerance = 0.0) {
    auto result = sew_shape(shape, tolerance);
    EXPECT_TRUE(result.has_value()) << result.error().message;
    return result.value_or(SewnShape());
}

TopoDS_Shape box(double x0, double y0, double z0, double x1, double y1, double z1) {
    return BRepPrimAPI_MakeBox(gp_Pnt(x0, y0, z0), gp_Pnt(x1, y1, z1)).Shape();
}

/// The shell of a box without its faces at x (or y, z): those whose corners all have it.
TopoDS_Shell open_box(const TopoDS_Shape& box, int axis, double at) {
    std::vector<TopoDS_Face> kept;
    for (const TopoDS_Face& face : occ::faces_of(box)) {
        bool there = true;
        for (TopExp_Explorer it(face, TopAbs_VERTEX); it.More(); it.Next()) {
            const double c = BRep_Tool::Pnt(TopoDS::Vertex(it.Current())).Coord(axis);
            there = there && std::abs(c - at) < 1e-9;
        }
        if (!there) {
            kept.push_back(face);
        }
    }
    return test::shell_of(kept);
}

/// The two halves of a box of 100 x 60 x 30, `gap` apart.
TopoDS_Compound halves(double gap) {
    return test::compound_of({open_box(box(0, 0, 0, 50, 60, 30), 1, 50.0),
                              open_box(box(50 + gap, 0, 0, 100, 60, 30), 1, 50.0 + gap)});
}

void expect_solid(const TopoDS_Shape& shape, double expected, double relative) {
    ASSERT_EQ(shape.ShapeType(), TopAbs_SOLID);
    EXPECT_TRUE(BRepCheck_Analyzer(shape).IsValid());
    EXPECT_NEAR(volume(shape), expected, relative * expected);
}

TEST(SewShells, JoinsTheHalvesOfABodyWhereverTheyStand) {
    for (const double gap : {0.0, 1e-15, 1e-6, 1e-3, 0.01, 0.05}) {
        for (const double scale : {1e-3, 1.0, 1e3}) {
            const SewnShape sewn = sew(test::moved(halves(gap), scale));
            EXPECT_EQ(sewn.free_edges_after, 0) << gap;
            EXPECT_EQ(sewn.sewn_edges, 4);
            EXPECT_NEAR(sewn.largest_gap, gap * scale, 1e-9 * scale + 1e-6 * gap);
            expect_solid(sewn.shape, 180000.0 * std::pow(scale, 3), 1e-3);
        }
    }
}

TEST(SewShells, LeavesAGapThatIsMeant) {
    const SewnShape sewn = sew(halves(0.5));
    EXPECT_FALSE(sewn.changed);
    EXPECT_EQ(sewn.free_edges_after, 8);
}

TEST(SewShells, TellsWhatItLeftAndWhy) {
    // 0.1 of 60 looks like a gap; the slot of 0.2 beside it forbids to close it
    TopoDS_Compound shape = halves(0.1);
    const TopoDS_Shape slot = box(20, 20, 29, 40, 20.2, 31);
    const TopoDS_Shape slotted = BRepAlgoAPI_Cut(box(0, 0, 0, 50, 60, 30), slot).Shape();
    std::vector<TopoDS_Face> outside;
    for (const TopoDS_Face& face : occ::faces_of(open_box(slotted, 1, 50.0))) {
        if (test::area(face) > 30.0) {
            outside.push_back(face);
        }
    }
    const SewnShape sewn = sew(test::compound_of(
        {test::shell_of(outside), open_box(box(50.1, 0, 0, 100, 60, 30), 1, 50.1)}));
    EXPECT_FALSE(sewn.changed);
    ASSERT_FALSE(sewn.left.empty());
    EXPECT_NEAR(sewn.left.front().gap, 0.1, 1e-9);
    EXPECT_NE(sewn.left.front().reason.find("smallest feature"), std::string::npos);
}

TEST(SewShells, ClosesACrackWithinOneShell) {
    // a box whose faces share all edges but one, or all but three
    for (const std::size_t cracks : {1U, 3U}) {
        std::vector<TopoDS_Face> faces = occ::faces_of(box(0, 0, 0, 20, 30, 40));
        const TopoDS_Face turned =
            TopoDS::Face(BRepBuilderAPI_Transform(faces[0], gp_Trsf(), /*Copy=*/true).Shape());
        const auto old_edges = occ::edges_of(faces[0]);
        const auto new_edges = occ::edges_of(turned);
        BRep_Builder builder;
        TopoDS_Face cracked = TopoDS::Face(faces[0].EmptyCopied());
        TopoDS_Wire wire;
        builder.MakeWire(wire);
        for (std::size_t i = 0; i < old_edges.size(); ++i) {
            if (i >= cracks) {
                builder.Add(wire, old_edges[i]);
                continue;
            }
            // an edge of its own between the same vertices
            TopoDS_Edge own = TopoDS::Edge(old_edges[i].EmptyCopied());
            for (TopoDS_Iterator it(old_edges[i]); it.More(); it.Next()) {
                builder.Add(own, it.Value());
            }
            builder.Add(wire, own);
        }
        wire.Closed(true);
        builder.Add(cracked, wire);
        faces[0] = cracked;
        const TopoDS_Shell shell = test::shell_of(faces);
        ASSERT_FALSE(census(shell).empty());
        const SewnShape sewn = sew(shell);
        EXPECT_EQ(sewn.sewn_edges, static_cast<int>(cracks));
        expect_solid(sewn.shape, 24000.0, 1e-9);
    }
}

TEST(SewShells, FindsOneHoleAcrossTwoShells) {
    // the halves of a box whose lid has a window across the joint
    std::vector<TopoDS_Shape> parts;
    for (const double x : {0.0, 50.0}) {
        const TopoDS_Shape whole =
            BRepAlgoAPI_Cut(box(x, 0, 0, x + 50, 60, 30), box(30, 15, 20, 70, 45, 40)).Shape();
        std::vector<TopoDS_Face> kept;
        for (const TopoDS_Face& face : occ::faces_of(open_box(whole, 1, 50.0))) {
            bool pocket = false;
            for (TopExp_Explorer it(face, TopAbs_VERTEX); it.More(); it.Next()) {
                pocket = pocket ||
                         std::abs(BRep_Tool::Pnt(TopoDS::Vertex(it.Current())).Z() - 20.0) < 1e-9;
            }
            if (!pocket) {
                kept.push_back(face);
            }
        }
        parts.push_back(test::shell_of(kept));
    }
    const SewnShape sewn = sew(test::compound_of(parts));
    EXPECT_EQ(census(sewn.shape), (Census{{"hole", 6}}));
}

TEST(SewShells, CutsEdgesWhereOthersEnd) {
    // a box whose lid is one face on a side of three, and three faces on a side of two
    const double h = 30.0;
    std::vector<TopoDS_Shape> parts{
        test::polygon({{0, 0, 0}, {0, 60, 0}, {100, 60, 0}, {100, 0, 0}}),
        test::polygon({{0, 0, h}, {100, 0, h}, {100, 60, h}, {0, 60, h}}),
        test::polygon({{0, 0, 0}, {0, 0, h}, {0, 60, h}, {0, 60, 0}}),
        test::polygon({{100, 0, 0}, {100, 60, 0}, {100, 60, h}, {100, 0, h}})};
    const std::vector<double> front{0, 30, 77, 100};
    for (std::size_t i = 0; i + 1 < front.size(); ++i) {
        parts.push_back(test::polygon(
            {{front[i], 0, 0}, {front[i + 1], 0, 0}, {front[i + 1], 0, h}, {front[i], 0, h}}));
    }
    const std::vector<double> back{0, 41, 100};
    for (std::size_t i = 0; i + 1 < back.size(); ++i) {
        parts.push_back(test::polygon(
            {{back[i], 60, 0}, {back[i], 60, h}, {back[i + 1], 60, h}, {back[i + 1], 60, 0}}));
    }
    for (const double scale : {1e-3, 1.0, 1e3}) {
        const SewnShape sewn = sew(test::moved(test::compound_of(parts), scale));
        EXPECT_EQ(sewn.free_edges_after, 0);
        expect_solid(sewn.shape, 180000.0 * std::pow(scale, 3), 1e-9);
    }
}

TEST(SewShells, LeavesBodiesThatTouchApart) {
    const TopoDS_Shape left = box(0, 0, 0, 10, 10, 10);
    for (const TopoDS_Shape& right :
         {box(10, 0, 0, 20, 10, 10), box(10, 10, 0, 20, 20, 10), box(10, 10, 10, 20, 20, 20)}) {
        const SewnShape sewn = sew(test::compound_of({left, right}));
        EXPECT_FALSE(sewn.changed);
        EXPECT_EQ(sewn.sewn_edges, 0);
    }
}

TEST(SewShells, KeepsTheSidesOfAThinWallApart) {
    // a plate of 0.1 without its rim, in two sheets and in one folded over
    const TopoDS_Shape plate = box(0, 0, 0, 100, 80, 0.1);
    std::vector<TopoDS_Shape> sheets;
    for (const TopoDS_Face& face : occ::faces_of(test::loosened(plate))) {
        if (test::area(face) > 100.0) {
            sheets.push_back(face);
        }
    }
    ASSERT_EQ(sheets.size(), 2U);
    EXPECT_FALSE(sew(test::compound_of(sheets)).changed);
    EXPECT_FALSE(sew(open_box(plate, 2, 0.0)).changed);
}

TEST(SewShells, MakesAPointOfAnEdgeThatOnlyOneSideHas) {
    // one corner of the lid is cut off by less than the model is good for
    const double d = 2e-5;
    std::vector<TopoDS_Shape> parts;
    for (const TopoDS_Face& face : occ::faces_of(test::loosened(box(0, 0, 0, 50, 60, 30)))) {
        parts.push_back(face);
    }
    parts.pop_back();  // the lid at z = 30
    parts.push_back(
        test::polygon({{d, 0, 30}, {50, 0, 30}, {50, 60, 30}, {0, 60, 30}, {0, d, 30}}));
    const SewnShape sewn = sew(test::compound_of(parts));
    EXPECT_EQ(sewn.free_edges_after, 0);
    expect_solid(sewn.shape, 90000.0, 1e-9);
}

TEST(SewShells, KeepsShortEdgesThatBothSidesHave) {
    const double d = 2e-5;
    const TopoDS_Shape chamfered =
        BRepAlgoAPI_Cut(
            box(0, 0, 0, 50, 60, 30),
            BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(25, 30, 10), gp_Dir(0, 0, 1)), d, 30).Shape())
            .Shape();
    const std::size_t faces = occ::faces_of(chamfered).size();
    const SewnShape sewn = sew(test::loosened(chamfered));
    EXPECT_EQ(sewn.free_edges_after, 0);
    EXPECT_EQ(occ::faces_of(sewn.shape).size(), faces);
    EXPECT_EQ(occ::edges_of(sewn.shape).size(), occ::edges_of(chamfered).size());
}

/// A box of 50 x 60 x 30 whose lid ends before y = 60, and by how much its vertices there are said
/// to be good.
TopoDS_Shape box_with_sliver(double width, double accuracy) {
    test::PolygonMesh mesh({{0, 0, 0},
                            {50, 0, 0},
                            {50, 60, 0},
                            {0, 60, 0},
                            {0, 0, 30},
                            {50, 0, 30},
                            {50, 60, 30},
                            {0, 60, 30},
                            {50, 60 - width, 30},
                            {0, 60 - width, 30}});
    const TopoDS_Shell shell = test::shell_of(
        {mesh.face({0, 3, 2, 1}), mesh.face({4, 5, 8, 9}), mesh.face({0, 1, 5, 4}),
         mesh.face({1, 2, 6, 8, 5}), mesh.face({2, 3, 7, 6}), mesh.face({3, 0, 4, 9, 7})});
    for (TopExp_Explorer it(shell, TopAbs_VERTEX); it.More(); it.Next()) {
        const TopoDS_Vertex vertex = TopoDS::Vertex(it.Current());
        if (BRep_Tool::Pnt(vertex).Y() > 59.0 && BRep_Tool::Pnt(vertex).Z() > 29.0) {
            BRep_Builder().UpdateVertex(vertex, accuracy);
        }
    }
    return shell;
}

TEST(SewShells, ClosesAHoleThatIsSmallerThanTheModelIsGood) {
    const SewnShape sewn = sew(box_with_sliver(0.02, 0.007));
    EXPECT_EQ(sewn.free_edges_after, 0);
    expect_solid(sewn.shape, 90000.0, 1e-3);
    // the same hole in a model that is better than that is a hole
    EXPECT_EQ(census(sew(box_with_sliver(0.02, 1e-7)).shape), (Census{{"hole", 4}}));
}

TEST(SewShells, MakesAPointOfASpeck) {
    // a corner of three faces cut off, the triangle missing
    for (const double accuracy : {0.007, 1e-7}) {
        const double d = 0.01;
        test::PolygonMesh mesh({{0, 0, 0},
                                {50, 0, 0},
                                {50, 60, 0},
                                {0, 60, 0},
                                {0, 0, 30},
                                {50, 0, 30},
                                {0, 60, 30},
                                {50 - d, 60, 30},
                                {50, 60 - d, 30},
                                {50, 60, 30 - d}});
        const TopoDS_Shell shell = test::shell_of(
            {mesh.face({0, 3, 2, 1}), mesh.face({4, 5, 8, 7, 6}), mesh.face({0, 1, 5, 4}),
             mesh.face({1, 2, 9, 8, 5}), mesh.face({2, 3, 6, 7, 9}), mesh.face({3, 0, 4, 6})});
        for (TopExp_Explorer it(shell, TopAbs_VERTEX); it.More(); it.Next()) {
            BRep_Builder().UpdateVertex(TopoDS::Vertex(it.Current()), accuracy);
        }
        const SewnShape sewn = sew(shell);
        if (accuracy > d / 2) {
            expect_solid(sewn.shape, 90000.0, 1e-3);
            EXPECT_EQ(occ::edges_of(sewn.shape).size(), 12U);
        } else {
            EXPECT_EQ(census(sewn.shape), (Census{{"hole", 3}}));
        }
    }
}

}  // namespace
}  // namespace suture

#include "suture/faces/join.h"

#include "support/properties.h"
#include "suture/faces/make_faces.h"

#include "kernel/detect/shapes.h"
#include "kernel/faces/holes.h"
#include <gtest/gtest.h>

#include <BRepCheck_Analyzer.hxx>
#include <BRep_Builder.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_MapOfShape.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Iterator.hxx>
#include <TopoDS_Solid.hxx>

#include <cmath>

namespace suture {
namespace {

using test::volume;

std::size_t count(const TopoDS_Shape& shape, TopAbs_ShapeEnum kind) {
    std::size_t found = 0;
    for (TopExp_Explorer it(shape, kind); it.More(); it.Next()) {
        ++found;
    }
    return found;
}

std::vector<TopoDS_Face> new_faces(const TopoDS_Shape& shape) {
    std::vector<TopoDS_Face> result;
    for (const test::OpenHole& open : test::holes_of(shape)) {
        const auto made = make_faces(open.loops, open.hole, open.fill);
        EXPECT_TRUE(made) << made.error().message;
        result.insert(result.end(), made->faces.begin(), made->faces.end());
    }
    return result;
}

TopoDS_Shape joined(const TopoDS_Shape& shape, const std::vector<TopoDS_Face>& faces) {
    const auto result = join(shape, faces);
    EXPECT_TRUE(result) << result.error().message;
    return result.value_or(TopoDS_Shape());
}

void expect_kept(const TopoDS_Shape& before, const TopoDS_Shape& after) {
    TopTools_MapOfShape kept;
    for (TopExp_Explorer it(after, TopAbs_FACE); it.More(); it.Next()) {
        kept.Add(it.Current());
    }
    for (TopExp_Explorer it(before, TopAbs_FACE); it.More(); it.Next()) {
        EXPECT_TRUE(kept.Contains(it.Current()));
    }
}

template <class... Shapes>
TopoDS_Compound compound_of(const Shapes&... shapes) {
    const BRep_Builder builder;
    TopoDS_Compound result;
    builder.MakeCompound(result);
    (builder.Add(result, shapes), ...);
    return result;
}

TEST(Join, MakesAClosedShellASolidWithItsOutsideOutside) {
    for (const auto& [name, shape, scale] : test::open_shells()) {
        SCOPED_TRACE(name);
        const auto faces = new_faces(shape);
        const TopoDS_Shape solid = joined(shape, faces);
        ASSERT_EQ(solid.ShapeType(), TopAbs_SOLID);
        EXPECT_TRUE(BRepCheck_Analyzer(solid).IsValid());
        EXPECT_EQ(count(solid, TopAbs_SHELL), 1U);
        EXPECT_EQ(count(solid, TopAbs_FACE), count(shape, TopAbs_FACE) + faces.size());
        expect_kept(shape, solid);
        const bool box = name.starts_with("box");
        const double truth = box ? 24.0 : 2.0 * kPi * kPi * 5.0 * 1.5 * 1.5;
        EXPECT_NEAR(volume(solid) / std::pow(scale, 3), truth, 1e-4 * truth);
    }
}

TEST(Join, LeavesAShellOpenUntilItsLastHoleIsFilled) {
    const TopoDS_Shape open = test::box_without({0, 1});
    const auto faces = new_faces(open);
    ASSERT_EQ(faces.size(), 2U);
    const TopoDS_Shape half = joined(open, {faces[0]});
    EXPECT_EQ(half.ShapeType(), TopAbs_SHELL);
    EXPECT_FALSE(BRep_Tool::IsClosed(half));
    const TopoDS_Shape whole = joined(half, {faces[1]});
    EXPECT_EQ(whole.ShapeType(), TopAbs_SOLID);
    EXPECT_NEAR(volume(whole), 24.0, 1e-9);
}

TEST(Join, GathersLooseFacesThatShareEdges) {
    const BRep_Builder builder;
    TopoDS_Compound loose;
    builder.MakeCompound(loose);
    const TopoDS_Shape open = test::box_without({2});
    for (const TopoDS_Face& face : occ::faces_of(open)) {
        builder.Add(loose, face);
    }
    const TopoDS_Shape result = joined(loose, new_faces(open));
    EXPECT_EQ(result.ShapeType(), TopAbs_COMPOUND);
    EXPECT_EQ(count(result, TopAbs_SOLID), 1U);
    EXPECT_EQ(count(result, TopAbs_FACE), 6U);
    EXPECT_NEAR(volume(result), 24.0, 1e-9);
}

TEST(Join, TouchesNothingButTheShellWithTheHole) {
    const TopoDS_Shape open = test::box_without({3});
    const TopoDS_Shape other = test::torus_without_a_cell(false);
    const TopoDS_Shape part = compound_of(other);
    const TopoDS_Shape model = compound_of(part, open);
    const TopoDS_Shape result = joined(model, new_faces(open));
    TopoDS_Iterator it(result);
    EXPECT_TRUE(it.Value().IsSame(part));
    it.Next();
    EXPECT_EQ(it.Value().ShapeType(), TopAbs_SOLID);
    EXPECT_NEAR(volume(it.Value()), 24.0, 1e-9);
}

TEST(Join, LeavesAShellInTheSolidThatItWasIn) {
    for (const bool inside_out : {false, true}) {
        const BRep_Builder builder;
        TopoDS_Solid solid;
        builder.MakeSolid(solid);
        builder.Add(solid, inside_out ? test::box_without({1}).Reversed() : test::box_without({1}));
        const TopoDS_Shape result = joined(solid, new_faces(solid));
        EXPECT_EQ(result.ShapeType(), TopAbs_SOLID);
        EXPECT_EQ(count(result, TopAbs_SHELL), 1U);
        EXPECT_NEAR(volume(result), 24.0, 1e-9);
    }
}

TEST(Join, GivesTheNewFaceToTheShellThatOwnsItsSides) {
    // two boxes with a common edge, beside the hole or away from it; either is the open one
    for (std::size_t missing = 0; missing < 6; ++missing) {
        for (const bool first_is_open : {true, false}) {
            const TopoDS_Compound boxes = test::boxes_with_common_edge(first_is_open, missing);
            const TopoDS_Shape result = joined(boxes, new_faces(boxes));
            EXPECT_TRUE(BRepCheck_Analyzer(result).IsValid());
            ASSERT_EQ(count(result, TopAbs_SHELL), 2U);
            EXPECT_EQ(count(result, TopAbs_SOLID), 2U);
            for (TopExp_Explorer it(result, TopAbs_SHELL); it.More(); it.Next()) {
                EXPECT_EQ(count(it.Current(), TopAbs_FACE), 6U);
                EXPECT_TRUE(BRep_Tool::IsClosed(it.Current()));
            }
        }
    }
}

TEST(Join, GivesTheShapeItselfWhereNothingIsAdded) {
    const TopoDS_Shape open = test::box_without({4});
    EXPECT_TRUE(joined(open, {}).IsSame(open));
}

}  // namespace
}  // namespace suture

#include "suture/check/face_knots.h"

#include "suture/judge/summary.h"

#include "kernel/check/shapes.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <BRepBuilderAPI_NurbsConvert.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>

namespace suture {
namespace {

std::vector<KnotLine> lines_of(const TopoDS_Shape& shape) {
    auto lines = measure_face_knots(shape, Progress{});
    EXPECT_TRUE(lines) << lines.error().message;
    return *lines;
}

TEST(FaceKnots, ACreaseInsideAFaceHasTheAngleOfItsPoles) {
    const auto roof = shapes::folded_spline({-0.2, -0.1, 0, -0.1, -0.2});
    const auto lines = lines_of(shapes::face_on(roof));
    ASSERT_EQ(lines.size(), 1U);
    EXPECT_EQ(lines[0].face, 1);
    EXPECT_TRUE(lines[0].is_u);
    EXPECT_EQ(lines[0].knot, 0.0);
    EXPECT_EQ(lines[0].parametric, 0);
    EXPECT_NEAR(lines[0].max_angle, 2.0 * std::atan(0.2), 1e-12);
    EXPECT_NEAR(lines[0].at.x(), 0.0, 1e-12);
    EXPECT_FALSE(is_near_miss(lines[0], Profile{}));  // sharp: 22.6 degrees
    const auto faint = lines_of(shapes::face_on(shapes::folded_spline({0, 0, 0, 0.01, 0.02})));
    EXPECT_NEAR(faint.at(0).max_angle, std::atan(0.02), 1e-12);
    EXPECT_TRUE(is_near_miss(faint[0], Profile{}));
}

TEST(FaceKnots, AJumpOfCurvatureInsideAFaceIsToldByBothDefinitions) {
    // z = x^2/4 before, x^2 after: curvatures 0.5 and 2 at x = 0.
    const auto lines = lines_of(shapes::face_on(shapes::folded_spline({0.25, 0, 0, 0, 1})));
    ASSERT_EQ(lines.size(), 1U);
    EXPECT_NEAR(lines[0].max_angle, 0.0, 1e-12);
    EXPECT_NEAR(lines[0].curvature_mismatch, 0.75, 1e-12);
    EXPECT_NEAR(lines[0].curvature_mismatch_sum, 0.6, 1e-12);
}

TEST(FaceKnots, KeepTheirFiguresWhenTheModelIsMovedAndScaled) {
    gp_Trsf turn;
    turn.SetRotation(gp_Ax1({1, 2, 3}, {1, 1, -2}), 0.7);
    gp_Trsf size;
    size.SetScale({-1, 4, 2}, 1e3);
    const auto face = shapes::face_on(shapes::folded_spline({0.25, 0, 0, 0.01, 1}));
    const auto expected = lines_of(face).at(0);
    const auto moved = lines_of(face.Moved(TopLoc_Location(turn))).at(0);
    const auto scaled = lines_of(BRepBuilderAPI_Transform(face, turn * size, true).Shape()).at(0);
    for (const KnotLine& line : {moved, scaled}) {
        EXPECT_NEAR(line.max_angle, expected.max_angle, 1e-9);
        EXPECT_NEAR(line.curvature_mismatch, expected.curvature_mismatch, 1e-9);
    }
    EXPECT_NEAR(moved.at.z(), gp_Pnt(0, 0, 0).Transformed(turn).Z() + 0.0,
                2.1);  // somewhere on the line
}

TEST(FaceKnots, OnlyLinesInsideTheFaceCount) {
    const auto roof = shapes::folded_spline({-0.2, -0.1, 0, -0.1, -0.2});
    const auto half = BRepBuilderAPI_MakeFace(roof, 0.0, 1.0, 0.0, 2.0, 1e-7).Face();
    EXPECT_TRUE(lines_of(half).empty());
    const auto part = BRepBuilderAPI_MakeFace(roof, 0.2, 1.0, 0.0, 2.0, 1e-7).Face();
    EXPECT_TRUE(lines_of(part).empty());
    const auto around = BRepBuilderAPI_MakeFace(roof, -0.3, 1.0, 0.5, 1.0, 1e-7).Face();
    EXPECT_EQ(lines_of(around).size(), 1U);
}

TEST(FaceKnots, OfARationalCylinderAreSmoothAllTheSame) {
    const auto spline =
        BRepBuilderAPI_NurbsConvert(BRepPrimAPI_MakeCylinder(2.0, 5.0).Shape()).Shape();
    for (const KnotLine& line : lines_of(spline)) {
        EXPECT_NEAR(line.max_angle, 0.0, 1e-9);
        EXPECT_NEAR(line.curvature_mismatch, 0.0, 1e-9);
    }
}

}  // namespace
}  // namespace suture

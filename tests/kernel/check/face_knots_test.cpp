#include "suture/check/face_knots.h"

#include "suture/judge/summary.h"

#include "kernel/check/shapes.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <BRepBuilderAPI_NurbsConvert.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <Geom_BSplineSurface.hxx>

#include <array>

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

/// Two flat sectors of a disc about the origin, meeting along x = y with a knot of multiplicity 2;
/// the poles of the tip are off by this much.
occ::Handle<Geom_BSplineSurface> tip_of_a_fan(double noise) {
    TColgp_Array2OfPnt poles(1, 5, 1, 2);
    const std::array<gp_XY, 5> rim = {gp_XY(2, 0), gp_XY(2, 1), gp_XY(1.5, 1.5), gp_XY(1, 2),
                                      gp_XY(0, 2)};
    for (int i = 1; i <= 5; ++i) {
        const auto& at = rim[static_cast<std::size_t>(i - 1)];
        poles(i, 1) = gp_Pnt(0.0, noise * i, noise * (i % 2 == 0 ? 1 : -1));
        poles(i, 2) = gp_Pnt(at.X(), at.Y(), 0.0);
    }
    TColStd_Array1OfReal u(1, 3);
    TColStd_Array1OfInteger times(1, 3);
    for (int i = 1; i <= 3; ++i) {
        u(i) = i - 2.0;
        times(i) = i == 2 ? 2 : 3;
    }
    TColStd_Array1OfReal v(1, 2);
    TColStd_Array1OfInteger ends(1, 2);
    v(1) = 0.0;
    v(2) = 1.0;
    ends.Init(2);
    return new Geom_BSplineSurface(poles, u, v, times, ends, 2, 1);
}

TEST(FaceKnots, ATipIsNoCrease) {
    for (const double noise : {0.0, 1e-13}) {
        const auto lines = lines_of(shapes::face_on(tip_of_a_fan(noise)));
        ASSERT_EQ(lines.size(), 1U);
        EXPECT_EQ(lines[0].samples, 5);  // of six, but not the tip
        EXPECT_LT(lines[0].max_angle, 1e-6) << noise;
    }
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

#include "suture/check/continuity.h"

#include "kernel/check/shapes.h"
#include <gtest/gtest.h>

#include <BRepBuilderAPI_Transform.hxx>
#include <TopLoc_Location.hxx>
#include <gp_Ax2.hxx>

#include <algorithm>

namespace suture {
namespace {

std::vector<EdgeContinuity> measure(const TopoDS_Shape& shape) {
    const auto report = measure_continuity(shape, Profile{}, {}, Progress{});
    EXPECT_TRUE(report) << report.error().message;
    return report->edges;
}

/// A crease with a gap, a capsule with a pole, and a rim: freeform, singular, closed form, and
/// nearly flat.
std::vector<TopoDS_Shape> subjects() {
    const auto wave = [](double shift) {
        return [shift](int i, int j) { return 0.2 * std::sin(2.0 * i + 1.3 * j) + shift; };
    };
    const auto left = shapes::face_on(shapes::height_field(-1, 0, 3, 4, wave(0.0)));
    const auto right = shapes::face_on(shapes::height_field(
        0, 1, 2, 4, [&](int i, int j) { return wave(3e-3)(3 - 2 * i, j) + 0.1 * i; }));
    return {shapes::sewn({left, right}, 1e-2), shapes::capsule(3.0), shapes::rounded_rim(5.0, 2.0),
            shapes::plane_into_cylinder(7.0 / 2e-4)};
}

gp_Trsf rotation() {
    gp_Trsf result;
    result.SetRotation(gp_Ax1({1, 2, 3}, {0.3, -0.5, 0.8}), 1.234);
    return result;
}
gp_Trsf mirror() {
    gp_Trsf result;
    result.SetMirror(gp_Ax2({1, 2, 3}, {0.3, -0.5, 0.8}));
    return result;
}
gp_Trsf scale(double factor) {
    gp_Trsf result;
    result.SetScale({1, 2, 3}, factor);
    return result;
}
TopoDS_Shape located(const TopoDS_Shape& shape, const gp_Trsf& trsf) {
    return shape.Located(TopLoc_Location(trsf), /*theRaiseExc=*/Standard_False);
}
TopoDS_Shape transformed(const TopoDS_Shape& shape, const gp_Trsf& trsf) {
    return BRepBuilderAPI_Transform(shape, trsf, /*theCopyGeom=*/Standard_True).Shape();
}

void expect_same(const TopoDS_Shape& original, const TopoDS_Shape& variant, double factor,
                 const std::string& what) {
    SCOPED_TRACE(what);
    const auto expected = measure(original);
    const auto found = measure(variant);
    ASSERT_EQ(found.size(), expected.size());
    for (std::size_t i = 0; i < found.size(); ++i) {
        SCOPED_TRACE(expected[i].edge);
        EXPECT_EQ(found[i].edge, expected[i].edge);
        EXPECT_EQ(found[i].faces, expected[i].faces);
        EXPECT_NEAR(found[i].length, factor * expected[i].length, 1e-9 * factor);
        EXPECT_NEAR(found[i].max_gap, factor * expected[i].max_gap, 1e-9 * factor);
        EXPECT_NEAR(found[i].edge_gap, factor * expected[i].edge_gap, 1e-9 * factor);
        EXPECT_NEAR(found[i].max_angle, expected[i].max_angle, 2e-8);
        EXPECT_NEAR(found[i].mean_angle, expected[i].mean_angle, 2e-8);
        EXPECT_NEAR(found[i].curvature_mismatch, expected[i].curvature_mismatch, 1e-6);
        EXPECT_EQ(found[i].opposite_concavity, expected[i].opposite_concavity);
        EXPECT_EQ(found[i].samples, expected[i].samples);
        EXPECT_EQ(found[i].note, expected[i].note);
    }
}

TEST(MeasureContinuity, GivesTheSameFiguresForMovedMirroredScaledAndReversedShapes) {
    for (const auto& shape : subjects()) {
        ASSERT_FALSE(measure(shape).empty());
        expect_same(shape, transformed(shape, rotation()), 1.0, "rotated");
        expect_same(shape, located(shape, rotation()), 1.0, "rotated by location");
        expect_same(shape, transformed(shape, mirror()), 1.0, "mirrored");
        expect_same(shape, located(shape, mirror()), 1.0, "mirrored by location");
        expect_same(shape, transformed(shape, scale(1e3)), 1e3, "scaled up");
        expect_same(shape, located(shape, scale(1e-3)), 1e-3, "scaled by location");
        expect_same(shape, shape.Reversed(), 1.0, "reversed");
        expect_same(shape, located(transformed(shape, rotation()), mirror()).Reversed(), 1.0,
                    "rotated, mirrored, reversed");
    }
}

TEST(MeasureContinuity, ReportsPlacesInTheFrameOfTheModel) {
    const auto shape = subjects().front();
    const auto before = measure(shape).front();
    const auto after = measure(located(shape, rotation())).front();
    gp_Pnt place(before.angle_at.x(), before.angle_at.y(), before.angle_at.z());
    place.Transform(rotation());
    EXPECT_NEAR((Eigen::Vector3d(place.X(), place.Y(), place.Z()) - after.angle_at).norm(), 0.0,
                1e-3);
}

}  // namespace
}  // namespace suture

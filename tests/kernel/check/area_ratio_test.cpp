#include "suture/check/area_ratio.h"

#include "kernel/check/shapes.h"
#include <gtest/gtest.h>

#include <BRepBuilderAPI_Transform.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <Geom_ConicalSurface.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <Geom_SphericalSurface.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>

namespace suture {
namespace {

AreaRatio measure(const std::vector<TopoDS_Face>& faces) {
    const auto found = measure_area_ratio(faces);
    EXPECT_TRUE(found) << found.error().message;
    return found.value_or(AreaRatio{});
}

/// What a ball of radius 1 leaves above a height, a cap of area 2 pi (1 - height).
TopoDS_Face cap(double height) {
    const auto ball = occ::make<Geom_SphericalSurface>(gp_Ax3(gp::XOY()), 1.0);
    return BRepBuilderAPI_MakeFace(ball, 0.0, 2.0 * kPi, std::asin(height), 0.5 * kPi, 1e-7);
}

TEST(AreaRatio, OfCapsIsThatOfCapOverDisc) {
    for (const double height : {0.9, 0.5, 0.0, -0.5, -0.9}) {
        const AreaRatio found = measure({cap(height)});
        EXPECT_EQ(found.loops, 1);
        EXPECT_NEAR(found.area, 2.0 * kPi * (1.0 - height), 0.02 * found.area);
        EXPECT_NEAR(found.spanning, kPi * (1.0 - height * height), 0.02 * found.spanning);
        EXPECT_NEAR(found.ratio(), 2.0 / (1.0 + height), 0.03 * found.ratio());
    }
}

TEST(AreaRatio, OfPlaneIsOneAlsoInTwoFaces) {
    const auto part = [](double from, double to) {
        return BRepBuilderAPI_MakeFace(gp_Pln(gp_Pnt(0, 0, 3), gp::DZ()), from, to, 0.0, 4.0)
            .Face();
    };
    EXPECT_NEAR(measure({part(0.0, 10.0)}).ratio(), 1.0, 0.02);
    const TopoDS_Shape both = shapes::sewn({part(0.0, 4.0), part(4.0, 10.0)});
    std::vector<TopoDS_Face> faces;
    for (TopExp_Explorer it(both, TopAbs_FACE); it.More(); it.Next()) {
        faces.push_back(TopoDS::Face(it.Current()));
    }
    ASSERT_EQ(faces.size(), 2U);
    const AreaRatio found = measure(faces);
    EXPECT_EQ(found.loops, 1);
    EXPECT_NEAR(found.ratio(), 1.0, 0.02);
}

TEST(AreaRatio, OfSaddleLoopIsNearTheMinimalSurface) {
    // z = x y over a square: its own area is hardly more than the smallest.
    const auto saddle =
        shapes::height_field(-1, 1, 1, 1, [](int i, int j) { return i == j ? 0.5 : -0.5; });
    EXPECT_NEAR(measure({shapes::face_on(saddle)}).ratio(), 1.0, 0.03);
}

TEST(AreaRatio, OfBandIsOne) {
    const auto tube = occ::make<Geom_CylindricalSurface>(gp_Ax3(gp::XOY()), 1.0);
    const TopoDS_Face band = BRepBuilderAPI_MakeFace(tube, 0.0, 2.0 * kPi, 0.0, 30.0, 1e-7);
    const AreaRatio found = measure({band});
    EXPECT_EQ(found.loops, 2);
    EXPECT_NEAR(found.ratio(), 1.0, 0.03);
}

TEST(AreaRatio, OfWholeBallSpansNothing) {
    const TopoDS_Shape ball = BRepPrimAPI_MakeSphere(2.0).Shape();
    const AreaRatio found = measure({TopoDS::Face(TopExp_Explorer(ball, TopAbs_FACE).Current())});
    EXPECT_EQ(found.loops, 0);
    EXPECT_EQ(found.ratio(), 0.0);
    EXPECT_NEAR(found.area, 16.0 * kPi, 0.02 * found.area);
}

TEST(AreaRatio, DoesNotDependOnSize) {
    for (const double factor : {1e-3, 1e3}) {
        gp_Trsf scale;
        scale.SetScale({1, 2, 3}, factor);
        const auto copy = BRepBuilderAPI_Transform(cap(-0.9), scale, Standard_True).Shape();
        EXPECT_NEAR(measure({TopoDS::Face(copy)}).ratio(), 20.0, 0.6);
    }
    EXPECT_FALSE(measure_area_ratio({}));
}

}  // namespace
}  // namespace suture

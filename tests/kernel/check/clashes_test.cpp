#include "suture/check/clashes.h"

#include "suture/occ/topology.h"

#include "kernel/check/shapes.h"
#include <gtest/gtest.h>

#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRepFilletAPI_MakeFillet.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <GeomAPI_PointsToBSpline.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <Geom_SphericalSurface.hxx>
#include <Geom_SurfaceOfLinearExtrusion.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <TopExp_Explorer.hxx>
#include <TopLoc_Location.hxx>
#include <TopoDS.hxx>

#include <numeric>

namespace suture {
namespace {

constexpr double kTolerance = 1e-3;

ClashReport look(const TopoDS_Shape& shape, std::vector<int> faces = {},
                 double tolerance = kTolerance) {
    if (faces.empty()) {
        faces.resize(static_cast<std::size_t>(occ::Numbering(shape).faces.Extent()));
        std::iota(faces.begin(), faces.end(), 1);
    }
    const auto report = find_clashes(shape, faces, tolerance, tolerance, Progress{});
    EXPECT_TRUE(report) << report.error().message;
    return report.value_or(ClashReport{});
}

TopoDS_Face square(double size, double z) {
    return BRepBuilderAPI_MakeFace(gp_Pln(gp_Pnt(0, 0, z), gp::DZ()), -size, size, -size, size);
}

TopoDS_Face tube(double radius, double from, double to) {
    const auto surface = occ::make<Geom_CylindricalSurface>(gp_Ax3(gp::XOY()), radius);
    return BRepBuilderAPI_MakeFace(surface, 0.0, 2.0 * kPi, from, to, 1e-7);
}

/// Part of a ball about the z axis, from its lowest point up, without the pole.
TopoDS_Face bowl(double radius, double lowest) {
    const auto surface =
        occ::make<Geom_SphericalSurface>(gp_Ax3(gp_Pnt(0, 0, lowest + radius), gp::DX()), radius);
    return BRepBuilderAPI_MakeFace(surface, 0.75 * kPi, 1.25 * kPi, -0.25 * kPi, 0.25 * kPi, 1e-7);
}

/// A sheet over a spline through these points, drawn out along y.
TopoDS_Face sheet(const std::vector<gp_Pnt>& points) {
    TColgp_Array1OfPnt through(1, static_cast<int>(points.size()));
    for (int i = 1; i <= through.Length(); ++i) {
        through(i) = points[static_cast<std::size_t>(i - 1)];
    }
    const auto curve = GeomAPI_PointsToBSpline(through).Curve();
    const auto surface = occ::make<Geom_SurfaceOfLinearExtrusion>(curve, gp::DY());
    return BRepBuilderAPI_MakeFace(surface, curve->FirstParameter(), curve->LastParameter(), 0.0,
                                   3.0, 1e-7);
}

TEST(Clashes, FindsPostThroughLid) {
    const auto report = look(shapes::compound({square(50.0, 0.0), tube(5.0, -3.0, 2.0)}), {1});
    ASSERT_EQ(report.clashes.size(), 1U);
    const Clash& clash = report.clashes.front();
    EXPECT_EQ(clash.face, 1);
    EXPECT_EQ(clash.other, 2);
    EXPECT_NEAR(clash.at.head<2>().norm(), 5.0, 1e-9);
    EXPECT_NEAR(clash.at.z(), 0.0, 1e-9);
    EXPECT_NEAR(clash.angle, 0.5 * kPi, 1e-9);
    // The tube ends 2 above the lid; the steps of the walk double.
    EXPECT_LE(clash.depth, 2.0 + 1e-9);
    EXPECT_GE(clash.depth, 1.0);
}

TEST(Clashes, FindsEitherFaceOfAPairOnceWhenBothAreNew) {
    const auto shape = shapes::compound({square(50.0, 0.0), tube(5.0, -3.0, 2.0)});
    EXPECT_EQ(look(shape, {1, 2}).clashes.size(), 1U);
    EXPECT_EQ(look(shape, {2}).clashes.front().face, 2);
}

TEST(Clashes, IgnoresTouching) {
    // A tube that ends on a plate, one that ends just above, and a ball that touches it.
    EXPECT_TRUE(look(shapes::compound({square(50.0, 0.0), tube(5.0, 0.0, 2.0)})).clashes.empty());
    EXPECT_TRUE(look(shapes::compound({square(50.0, 0.0), tube(5.0, 1e-6, 2.0)})).clashes.empty());
    EXPECT_TRUE(look(shapes::compound({square(50.0, 0.0), bowl(10.0, 0.0)})).clashes.empty());
    // A plate whose border lies on the tube's wall, from within.
    const TopoDS_Face disc =
        BRepBuilderAPI_MakeFace(gp_Pln(gp_Pnt(0, 0, 1), gp::DZ()), -3.0, 3.0, -4.0, 4.0);
    EXPECT_TRUE(look(shapes::compound({disc, tube(5.0, 0.0, 2.0)})).clashes.empty());
}

TEST(Clashes, DepthOfDippingBallIsWhatGoesThrough) {
    for (const double dip : {0.05, 0.2, 1.0}) {
        const auto report = look(shapes::compound({square(20.0, 0.0), bowl(10.0, -dip)}));
        ASSERT_EQ(report.clashes.size(), 1U) << dip;
        EXPECT_LE(report.clashes.front().depth, dip * (1.0 + 1e-9));
        EXPECT_GE(report.clashes.front().depth, 0.2 * dip);
        const double angle = std::acos((10.0 - dip) / 10.0);
        EXPECT_NEAR(report.clashes.front().angle, angle, 1e-6);
    }
    EXPECT_TRUE(look(shapes::compound({square(20.0, 0.0), bowl(10.0, -5e-4)})).clashes.empty());
}

TEST(Clashes, FindsNoneInSoundBodies) {
    const TopoDS_Shape box = BRepPrimAPI_MakeBox(10.0, 20.0, 30.0).Shape();
    BRepFilletAPI_MakeFillet fillet(box);
    for (TopExp_Explorer it(box, TopAbs_EDGE); it.More(); it.Next()) {
        fillet.Add(2.0, TopoDS::Edge(it.Current()));
    }
    for (const TopoDS_Shape& body :
         {box, fillet.Shape(), shapes::capsule(3.0), shapes::rounded_rim(5.0, 2.0),
          shapes::plane_into_cylinder(40.0), shapes::folded_planes(radians(150.0)),
          BRepPrimAPI_MakeSphere(7.0).Shape()}) {
        const auto report = look(body);
        EXPECT_TRUE(report.clashes.empty());
        EXPECT_TRUE(report.overlays.empty());
    }
}

TEST(Clashes, FindsFaceThatPassesThroughItself) {
    const auto report = look(
        sheet({{-4, 0, 0}, {2, 0, 1}, {3, 0, 4}, {0, 0, 5}, {-3, 0, 4}, {-2, 0, 1}, {4, 0, 0}}));
    ASSERT_EQ(report.clashes.size(), 1U);
    EXPECT_EQ(report.clashes.front().face, report.clashes.front().other);
    EXPECT_NEAR(report.clashes.front().at.x(), 0.0, 0.2);
    EXPECT_GT(report.clashes.front().depth, 0.5);
    // The same loop, not closed.
    EXPECT_TRUE(
        look(
            sheet({{-4, 0, 0}, {-1, 0, 1}, {-3, 0, 4}, {0, 0, 5}, {3, 0, 4}, {1, 0, 1}, {4, 0, 0}}))
            .clashes.empty());
}

TEST(Clashes, SeesOnlyWhatLiesWithinTheLoops) {
    // The plane of the plate cuts the tube, the plate lies beside it.
    const TopoDS_Face beside =
        BRepBuilderAPI_MakeFace(gp_Pln(gp_Pnt(0, 0, 1), gp::DZ()), 5.5, 9.0, -9.0, 9.0);
    EXPECT_TRUE(look(shapes::compound({beside, tube(5.0, 0.0, 2.0)})).clashes.empty());
}

TEST(Clashes, FindsFaceThatLiesOnAnother) {
    const auto on = [](double z, double shift) {
        const TopoDS_Face upper = BRepBuilderAPI_MakeFace(gp_Pln(gp_Pnt(0, 0, z), gp::DZ()), shift,
                                                          shift + 10.0, 0.0, 7.0);
        const TopoDS_Face lower =
            BRepBuilderAPI_MakeFace(gp_Pln(gp::Origin(), gp::DZ()), 0.0, 10.0, 0.0, 7.0);
        return look(shapes::compound({upper.Reversed(), lower}), {1});
    };
    const auto whole = on(5e-4, 0.0);
    ASSERT_EQ(whole.overlays.size(), 1U);
    EXPECT_NEAR(whole.overlays.front().share, 1.0, 1e-12);
    EXPECT_NEAR(whole.overlays.front().distance, 5e-4, 1e-12);
    EXPECT_TRUE(whole.overlays.front().opposed);
    EXPECT_TRUE(whole.clashes.empty());
    const auto part = on(0.0, 5.0);
    ASSERT_EQ(part.overlays.size(), 1U);
    EXPECT_NEAR(part.overlays.front().share, 0.5, 0.1);
    EXPECT_TRUE(on(2e-3, 0.0).overlays.empty());
    EXPECT_TRUE(on(0.0, 10.5).overlays.empty());
}

TEST(Clashes, DoesNotDependOnPlaceSizeOrOrientation) {
    const auto shape =
        shapes::compound({square(20.0, 0.0), bowl(10.0, -1.0), tube(3.0, -5.0, 0.0)});
    const auto expected = look(shape, {1});
    ASSERT_EQ(expected.clashes.size(), 1U);
    gp_Trsf turn;
    turn.SetRotation(gp_Ax1({1, 2, 3}, {0.3, -0.5, 0.8}), 1.234);
    gp_Trsf mirror;
    mirror.SetMirror(gp_Ax2({1, 2, 3}, {0.3, -0.5, 0.8}));
    for (const double factor : {1.0, 1e-3, 1e3}) {
        gp_Trsf scale;
        scale.SetScale({1, 2, 3}, factor);
        for (const gp_Trsf& trsf : {scale * turn, scale * mirror}) {
            const auto copied = BRepBuilderAPI_Transform(shape, trsf, Standard_True).Shape();
            const auto located = shape.Located(TopLoc_Location(trsf), Standard_False);
            for (const TopoDS_Shape& variant : {copied, located, copied.Reversed()}) {
                const auto found = look(variant, {1}, factor * kTolerance);
                ASSERT_EQ(found.clashes.size(), 1U) << factor;
                EXPECT_EQ(found.clashes.front().other, 2);
                EXPECT_NEAR(found.clashes.front().depth / factor, expected.clashes.front().depth,
                            0.5);
            }
        }
    }
}

TEST(Clashes, RefusesWhatIsNotThere) {
    EXPECT_FALSE(find_clashes({}, {}, 1e-3, 1e-3, {}));
    EXPECT_FALSE(find_clashes(square(1.0, 0.0), {2}, 1e-3, 1e-3, {}));
    EXPECT_FALSE(find_clashes(square(1.0, 0.0), {1}, 0.0, 1e-3, {}));
    std::stop_source stop;
    stop.request_stop();
    const auto cancelled = find_clashes(square(1.0, 0.0), {1}, 1e-3, 1e-3, {{}, stop.get_token()});
    ASSERT_FALSE(cancelled);
    EXPECT_EQ(cancelled.error().code, ErrorCode::Cancelled);
}

}  // namespace
}  // namespace suture

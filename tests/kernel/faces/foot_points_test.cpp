#include "suture/faces/foot_points.h"

#include "suture/occ/convert.h"

#include <gtest/gtest.h>

#include <GeomFill.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <Geom_Line.hxx>
#include <Geom_SphericalSurface.hxx>
#include <Geom_TrimmedCurve.hxx>

#include <cmath>

namespace suture {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using occ::Handle;

/// A line above a cylinder of radius r, along its axis: its feet are known.
struct AboveCylinder {
    double r, height, angle = 0.7;
    gp_Ax3 axes{gp_Pnt(1.0, 2.0, 3.0), gp_Dir(1.0, 1.0, 2.0)};
    Handle<Geom_Surface> surface = occ::make<Geom_CylindricalSurface>(axes, r);

    [[nodiscard]] Handle<Geom_Curve> line() const {
        const gp_Pnt start = surface->Value(angle, 0.0);
        const gp_Vec out = gp_Vec(axes.Location(), start).Normalized();
        return occ::make<Geom_Line>(start.Translated(out * height), axes.Direction());
    }
};

TEST(FootPoints, AreTheNearestOfACylinderWhateverTheLayoutSays) {
    for (const double size : {1e-3, 1.0, 1e3}) {
        const AboveCylinder over{2.0 * size, 1e-3 * size};
        const double length = 5.0 * size;
        const auto layout = [&](double t) -> Vector2d {
            const double off = std::sin(M_PI * t / length);
            return {over.angle + 0.05 * off, t + 0.04 * size * off};
        };
        const auto feet = foot_points(over.line(), 0.0, length, over.surface, layout,
                                      {layout(0.0), layout(length)});
        for (int k = 0; k <= 50; ++k) {
            const double t = length * k / 50;
            EXPECT_NEAR(feet(t).x(), over.angle, 1e-12) << k;
            EXPECT_NEAR(feet(t).y(), t, 1e-12 * length) << k;
        }
    }
}

TEST(FootPoints, EndWhereTheLayoutEnds) {
    const AboveCylinder over{2.0, 1e-3};
    const auto layout = [&](double t) -> Vector2d { return {over.angle + 0.01, t - 0.02}; };
    const auto feet =
        foot_points(over.line(), 0.0, 5.0, over.surface, layout, {layout(0.0), layout(5.0)});
    EXPECT_LT((feet(0.0) - layout(0.0)).norm(), 1e-15);
    EXPECT_LT((feet(5.0) - layout(5.0)).norm(), 1e-15);
    // And are the feet again where a fifth of the edge is passed.
    for (const double t : {1.5, 2.5, 3.5}) {
        EXPECT_NEAR(feet(t).x(), over.angle, 1e-4);
        EXPECT_NEAR(feet(t).y(), t, 2e-4);
    }
}

TEST(FootPoints, StayOnTheBorderOfASurface) {
    // From the line u = 0 along y, 4 long, to one that rises: v runs from the one to the other.
    const auto border = occ::make<Geom_TrimmedCurve>(
        occ::make<Geom_Line>(gp_Pnt(0, 0, 0), gp_Dir(0, 1, 0)), 0.0, 4.0);
    const auto other = occ::make<Geom_TrimmedCurve>(
        occ::make<Geom_Line>(gp_Pnt(3, 0, 0), gp_Dir(0, 4, 1)), 0.0, 4.0);
    const Handle<Geom_Surface> patch = GeomFill::Surface(border, other);
    double u0 = 0.0;
    double u1 = 0.0;
    double v0 = 0.0;
    double v1 = 0.0;
    patch->Bounds(u0, u1, v0, v1);
    for (const double beside : {-1e-3, 1e-3}) {  // out of the patch, and in it
        const auto line = occ::make<Geom_Line>(gp_Pnt(beside, 0, 1e-3), gp_Dir(0, 1, 0));
        const auto layout = [&](double t) -> Vector2d {
            return {u0 + (u1 - u0) * (t / 4.0 + 0.03 * std::sin(M_PI * t / 4.0)), v0};
        };
        const auto feet = foot_points(line, 0.0, 4.0, patch, layout, {layout(0.0), layout(4.0)});
        for (int k = 0; k <= 20; ++k) {
            EXPECT_EQ(feet(0.2 * k).y(), v0);
            EXPECT_NEAR(feet(0.2 * k).x(), u0 + (u1 - u0) * 0.05 * k, 1e-6);
        }
    }
}

TEST(FootPoints, TakesTheLayoutWhereTheSurfaceIsSingular) {
    const Handle<Geom_Surface> sphere =
        occ::make<Geom_SphericalSurface>(gp_Ax3(gp_Pnt(), gp_Dir(0, 0, 1)), 2.0);
    const Vector2d pole(0.3, M_PI / 2.0);
    EXPECT_EQ(foot_point(Vector3d(1e-4, 0.0, 2.001), *sphere, pole), pole);
}

TEST(FootPoints, FindTheFootFromFarOnASphere) {
    const Handle<Geom_Surface> sphere =
        occ::make<Geom_SphericalSurface>(gp_Ax3(gp_Pnt(), gp_Dir(0, 0, 1)), 2.0);
    const gp_Pnt on = sphere->Value(1.1, 0.4);
    const Vector3d above = 1.1 * occ::from_occ(on);
    const Vector2d foot = foot_point(above, *sphere, Vector2d(1.2, 0.3));
    EXPECT_NEAR(foot.x(), 1.1, 1e-13);
    EXPECT_NEAR(foot.y(), 0.4, 1e-13);
}

}  // namespace
}  // namespace suture

#include "bench/fairness.h"

#include <gtest/gtest.h>

#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <Geom_SphericalSurface.hxx>
#include <Geom_ToroidalSurface.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <TopoDS.hxx>
#include <gp_Ax3.hxx>
#include <gp_Trsf.hxx>

#include <cmath>
#include <numbers>

namespace suture::bench {
namespace {

using std::numbers::pi;

// What a grid of 100 cells leaves of smooth integrals.
constexpr double kGrid = 1e-3;

TopoDS_Face face_of(const Handle(Geom_Surface) & surface, double u0, double u1, double v0,
                    double v1) {
    return BRepBuilderAPI_MakeFace(surface, u0, u1, v0, v1, 1e-7).Face();
}

/// z = f(x, y) over a square, as the polynomial patch of degree 3 that it is: f has to be a cubic.
template <class Height>
TopoDS_Face cubic(double half, const Height& f) {
    // Poles of x and y are even; those of z come from values at the 16 nodes.
    constexpr int n = 4;
    const double node[n] = {0.0, 1.0 / 3.0, 2.0 / 3.0, 1.0};
    double z[n][n];
    for (int i = 0; i < n; ++i) {
        for (int j = 0; j < n; ++j) {
            z[i][j] = f(half * (2.0 * node[i] - 1.0), half * (2.0 * node[j] - 1.0));
        }
    }
    const auto poles_of = [](double(&value)[n]) {
        const double a = value[0], b = value[1], c = value[2], d = value[3];
        value[1] = (-5.0 * a + 18.0 * b - 9.0 * c + 2.0 * d) / 6.0;
        value[2] = (2.0 * a - 9.0 * b + 18.0 * c - 5.0 * d) / 6.0;
    };
    for (auto& row : z) {
        poles_of(row);
    }
    for (int j = 0; j < n; ++j) {
        double column[n] = {z[0][j], z[1][j], z[2][j], z[3][j]};
        poles_of(column);
        for (int i = 0; i < n; ++i) {
            z[i][j] = column[i];
        }
    }
    TColgp_Array2OfPnt poles(1, n, 1, n);
    for (int i = 0; i < n; ++i) {
        for (int j = 0; j < n; ++j) {
            poles(i + 1, j + 1) =
                gp_Pnt(half * (2.0 * node[i] - 1.0), half * (2.0 * node[j] - 1.0), z[i][j]);
        }
    }
    TColStd_Array1OfReal knots(1, 2);
    knots(1) = 0.0;
    knots(2) = 1.0;
    TColStd_Array1OfInteger multiplicities(1, 2);
    multiplicities.Init(4);
    const Handle(Geom_Surface) surface =
        new Geom_BSplineSurface(poles, knots, knots, multiplicities, multiplicities, 3, 3);
    return BRepBuilderAPI_MakeFace(surface, 1e-7).Face();
}

TEST(Fairness, OfSpheresAndCylindersNothingVaries) {
    const Handle(Geom_Surface) sphere = new Geom_SphericalSurface(gp_Ax3(), 2.5);
    const Fairness ball = fairness_of(face_of(sphere, 0.2, 1.9, -0.8, pi / 2));
    const double area = 2.5 * 2.5 * 1.7 * (1.0 + std::sin(0.8));
    EXPECT_NEAR(ball.area, area, kGrid * area);
    EXPECT_NEAR(ball.bending, 2.0 * area / (2.5 * 2.5), kGrid * area);
    EXPECT_LT(ball.variation, 1e-20);
    EXPECT_EQ(ball.sign_changes, 0);
    const Handle(Geom_Surface) cylinder = new Geom_CylindricalSurface(gp_Ax3(), 0.5);
    const Fairness pipe = fairness_of(face_of(cylinder, 0.0, 2.0 * pi, 1.0, 4.0));
    EXPECT_NEAR(pipe.bending, 6.0 * pi / 0.5, kGrid);
    EXPECT_LT(pipe.variation, 1e-20);
    EXPECT_EQ(pipe.sign_changes, 0);
}

TEST(Fairness, OfATorusIsWhatItsClosedFormSays) {
    constexpr double kR = 5.0, kr = 2.0;
    // Along a meridian k1 = 1/r, along a parallel k2 = cos v / (R + r cos v): of the form's
    // gradient only dk2/ds is left, and by Codazzi's equation it counts three times.
    double variation = 0.0;
    constexpr int kSteps = 1000;
    for (int k = 0; k < kSteps; ++k) {
        const double v = 2.0 * pi * (k + 0.5) / kSteps;
        const double reach = kR + kr * std::cos(v);
        const double slope = -kR * std::sin(v) / (kr * reach * reach);
        variation += 3.0 * slope * slope * reach * kr * 2.0 * pi * 2.0 * pi / kSteps;
    }
    const Handle(Geom_Surface) torus = new Geom_ToroidalSurface(gp_Ax3(), kR, kr);
    const Fairness whole = fairness_of(face_of(torus, 0.0, 2.0 * pi, 0.0, 2.0 * pi));
    EXPECT_NEAR(whole.area, 4.0 * pi * pi * kR * kr, kGrid);
    EXPECT_NEAR(whole.variation, variation, kGrid * variation);
    EXPECT_EQ(whole.sign_changes, 1);  // outside and inside, each one part across the seam
}

TEST(Fairness, CountsThePartsOfOneSign) {
    const auto saddle = [](double x, double y) { return 0.3 * (x * x - y * y); };
    EXPECT_EQ(fairness_of(cubic(1.0, saddle)).sign_changes, 0);
    // z = x^3 / 3 + y^2: the Gauss curvature has the sign of x.
    const auto ridge = [](double x, double y) { return x * x * x / 3.0 + y * y; };
    EXPECT_EQ(fairness_of(cubic(1.0, ridge)).sign_changes, 1);
    // z = x^3 + y^3: that of x y, so that each of the four quarters is a part.
    const auto quarters = [](double x, double y) { return x * x * x + y * y * y; };
    EXPECT_EQ(fairness_of(cubic(1.0, quarters)).sign_changes, 3);
}

TEST(Fairness, TurnsAndGrowsWithTheFace) {
    const auto ridge = [](double x, double y) { return 0.2 * x * x * x + 0.4 * x * y + y * y; };
    const TopoDS_Face face = cubic(1.5, ridge);
    const Fairness before = fairness_of(face);
    gp_Trsf larger, turned;
    larger.SetScaleFactor(3.0);
    turned.SetRotation(gp_Ax1(gp_Pnt(1.0, 2.0, 3.0), gp_Dir(1.0, -2.0, 0.5)), 0.7);
    const TopoDS_Face moved =
        TopoDS::Face(BRepBuilderAPI_Transform(face, turned * larger, true).Shape());
    const Fairness after = fairness_of(moved);
    EXPECT_NEAR(after.variation, before.variation / 9.0, 1e-9 * before.variation);
    EXPECT_NEAR(after.bending, before.bending, 1e-9 * before.bending);
    EXPECT_EQ(after.sign_changes, before.sign_changes);
}

}  // namespace
}  // namespace suture::bench

#include "suture/check/certify/certify_edges.h"
#include "suture/check/certify/taylor_model.h"

#include "kernel/check/certified.h"
#include "kernel/check/shapes.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <BRepBuilderAPI_NurbsConvert.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>

#include <random>

namespace suture {
namespace {

using certify::TaylorModel;

TEST(TaylorModels, EncloseSumsProductsRootsAndInverses) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> number(-1.0, 1.0);
    for (int trial = 0; trial < 200; ++trial) {
        const double a = 2.0 + number(random);
        const double b = 0.8 * number(random);
        const double c = 3.0 * number(random);
        const double h = number(random);
        const TaylorModel x = TaylorModel::linear(0.0, 1.0);
        const TaylorModel f = TaylorModel(a) + TaylorModel(b) * x;
        const TaylorModel g = certify::cosine(c, h) * x * x + sqrt(f) * inverse(f * f);
        const auto range = g.range();
        double low = 1e9;
        double high = -1e9;
        for (int k = 0; k <= 200; ++k) {
            const double s = k / 100.0 - 1.0;
            const double value = std::cos(c + h * s) * s * s + std::pow(a + b * s, -1.5);
            EXPECT_GE(value, range.low);
            EXPECT_LE(value, range.high);
            low = std::min(low, value);
            high = std::max(high, value);
        }
        if (g.known()) {
            EXPECT_LT(range.high - range.low, 1.5 * (high - low) + 0.2);
        }
    }
}

TEST(TaylorModels, KnowNothingOfTheInverseOfWhatVanishes) {
    const TaylorModel x = TaylorModel::linear(0.0, 1.0);
    EXPECT_FALSE(inverse(x).known());
    EXPECT_FALSE(sqrt(x - TaylorModel(0.1)).known());
    EXPECT_TRUE(inverse(x + TaylorModel(3.0)).known());
}

TEST(TaylorModels, BoundAPolynomialByItsExtremeBernsteinCoefficients) {
    // (1 - x^2)^2 lies in [0, 1].
    const TaylorModel x = TaylorModel::linear(0.0, 1.0);
    const TaylorModel one_minus = TaylorModel(1.0) - x * x;
    const auto range = (one_minus * one_minus).range();
    EXPECT_NEAR(range.low, 0.0, 0.2);
    EXPECT_LE(range.low, 0.0);
    EXPECT_GE(range.high, 1.0);
    EXPECT_LE(range.high, 1.3);
}

TEST(CertifyEdges, PlanesAtKnownAnglesAreBoundedSharply) {
    for (const double degree : {0.0, 1e-3, 0.02, 1.0, 30.0, 90.0, 150.0, 179.0, 180.0}) {
        for (const Certified& edge : certify_all(shapes::folded_planes(radians(degree)))) {
            ASSERT_TRUE(edge.certificate.certified) << edge.certificate.reason;
            EXPECT_GE(edge.certificate.angle, radians(degree) * (1.0 - 1e-15));
            EXPECT_NEAR(edge.certificate.angle, radians(degree), 1e-6);
            EXPECT_NEAR(edge.certificate.gap, 0.0, 1e-12);
        }
    }
}

TEST(CertifyEdges, ElementarySurfacesThatAreTangentAreProvenToBe) {
    for (const TopoDS_Shape& shape :
         {shapes::plane_into_cylinder(2.5), shapes::rounded_rim(5, 2), shapes::capsule(3.0)}) {
        expect_sound_and_tight(shape, 1);
        for (const Certified& edge : certify_all(shape)) {
            if (edge.measured.faces[0] != edge.measured.faces[1]) {
                EXPECT_TRUE(edge.certificate.certified) << edge.certificate.reason;
                // As sharp as was asked for: a twentieth of a fifth of the limits.
                EXPECT_LE(edge.certificate.angle, radians(1e-4));
                EXPECT_LE(edge.certificate.gap, 1e-5);
            }
        }
    }
}

TEST(CertifyEdges, SolidsOfAllElementarySurfacesAreBounded) {
    expect_sound_and_tight(BRepPrimAPI_MakeBox(1, 2, 3).Shape(), 12);
    expect_sound_and_tight(BRepPrimAPI_MakeCone(1.0, 3.0, 4.0, 2.0).Shape(), 6);
    expect_sound_and_tight(BRepPrimAPI_MakeCylinder(1.0, 4.0).Shape(), 3);
}

TEST(CertifyEdges, SplinesAreBoundedAlsoWhereTheyAreRationalMovedAndMirrored) {
    const TopoDS_Shape spline = BRepBuilderAPI_NurbsConvert(shapes::rounded_rim(5.0, 2.0)).Shape();
    gp_Trsf turn;
    turn.SetRotation(gp_Ax1({1, 2, 3}, {1, 1, -2}), 0.7);
    gp_Trsf mirror;
    mirror.SetMirror(gp_Ax2({5, 0, 1}, {0.2, 1, 0.4}));
    gp_Trsf size;
    size.SetScale({-1, 4, 2}, 10.0);
    expect_sound_and_tight(spline, 1);
    expect_sound_and_tight(spline.Moved(TopLoc_Location(turn * mirror), false), 1);
    expect_sound_and_tight(BRepBuilderAPI_Transform(spline, size * turn, true).Shape(), 1);
}

/// Height fields that meet along x = 0 with a gap and an angle that wave along y.
TopoDS_Shape wavy_seam(double gap, double slope) {
    const auto left = shapes::height_field(
        -1, 0, 3, 4, [&](int i, int j) { return 0.02 * j * i + (i == 3 ? gap * (j % 2) : 0.0); });
    const auto right = shapes::height_field(0, 1, 2, 5, [&](int i, int j) {
        return 0.06 * 0.8 * j + i * (0.02 * j + slope * ((j * j) % 3));
    });
    return shapes::sewn({shapes::face_on(left), shapes::face_on(right)}, 0.1);
}

TEST(CertifyEdges, WavesOfGapAndAngleBetweenSplinesAreBoundedAboveTheirPeaks) {
    for (const double gap : {0.0, 1e-6, 1e-3, 2e-2}) {
        expect_sound_and_tight(wavy_seam(gap, 0.003), 1);
        expect_sound_and_tight(wavy_seam(gap, 0.3), 1);
    }
}

TEST(CertifyEdges, AnEdgeBesideItsSurfacesBorderIsBoundedByTheNearestPointOnTheBorder) {
    // A slot of a known width: the nearest points lie on the borders, the gap is the slot's width.
    const double gap = 0.0125;
    const auto flat = [](double x0, double x1) {
        return shapes::face_on(shapes::height_field(x0, x1, 2, 3, [](int, int) { return 0.0; }));
    };
    for (const Certified& edge :
         certify_all(shapes::sewn({flat(-1.0, 0.0), flat(gap, 1.0)}, 2.0 * gap))) {
        ASSERT_TRUE(edge.certificate.certified) << edge.certificate.reason;
        EXPECT_GE(edge.certificate.gap, gap * (1.0 - 1e-12));
        EXPECT_NEAR(edge.certificate.gap, gap, 1e-6);
    }
}

TEST(CertifyEdges, WhatCannotBeCertifiedIsNamedWithTheReason) {
    // The straight edges of half a cone run into its apex.
    int named = 0;
    for (const Certified& edge : certify_all(BRepPrimAPI_MakeCone(0.0, 3.0, 4.0, kPi).Shape())) {
        if (!edge.certificate.certified) {
            EXPECT_THAT(edge.certificate.reason, testing::HasSubstr("Face1"));
            ++named;
        }
    }
    EXPECT_EQ(named, 2);
}

TEST(CertifyEdges, RefusesASlackThatIsNone) {
    const auto shape = shapes::capsule(1.0);
    EXPECT_EQ(certify_edges(shape, {}, Profile{}, 0.0, Progress{}).error().code, ErrorCode::Usage);
}

}  // namespace
}  // namespace suture

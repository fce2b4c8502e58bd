#include "suture/occ/convert.h"

#include "support/windows.h"

#include <gtest/gtest.h>

#include <GeomConvert.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_BezierSurface.hxx>
#include <Geom_ConicalSurface.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <Geom_OffsetSurface.hxx>
#include <Geom_Plane.hxx>
#include <Geom_RectangularTrimmedSurface.hxx>
#include <Geom_SphericalSurface.hxx>
#include <Geom_ToroidalSurface.hxx>
#include <TColgp_Array2OfPnt.hxx>

namespace suture::occ {
namespace {

using Eigen::Vector2d;

/// A frame with Y = -(Z x X).
gp_Ax3 left_handed() {
    gp_Ax3 axes(gp_Pnt(1, 2, 3), gp_Dir(0.3, -0.5, 0.9), gp_Dir(1, 1, 0.2));
    axes.YReverse();
    return axes;
}

std::vector<Handle<Geom_Surface>> occt_forms(const gp_Ax3& axes) {
    return {make<Geom_Plane>(axes), make<Geom_CylindricalSurface>(axes, 2.0),
            make<Geom_ConicalSurface>(axes, 0.4, 1.5), make<Geom_SphericalSurface>(axes, 3.0),
            make<Geom_ToroidalSurface>(axes, 5.0, 1.25)};
}

double largest_difference(const Handle<Geom_Surface>& occt, const ClosedForm& ours) {
    double largest = 0.0;
    for (double u = 0.05; u < 1.0; u += 0.1) {
        for (double v = 0.05; v < 1.0; v += 0.13) {
            const Vector2d uv = ours.sign.cwiseProduct(Vector2d(u, v));
            const auto p = evaluate(ours.surface, uv.x(), uv.y()).point;
            largest = std::max(largest, (p - from_occ(occt->Value(u, v))).norm());
        }
    }
    return largest;
}

TEST(FromOcc, GivesEveryClosedFormPointByPointInFramesOfBothHands) {
    for (const gp_Ax3& axes : {gp_Ax3(gp_Pnt(4, 0, -1), gp_Dir(1, 2, 3)), left_handed()}) {
        for (const auto& surface : occt_forms(axes)) {
            const auto ours = from_occ(surface);
            ASSERT_TRUE(ours) << surface->DynamicType()->Name();
            EXPECT_LT(largest_difference(surface, *ours), 1e-14 * 10)
                << surface->DynamicType()->Name();
        }
    }
}

TEST(FromOcc, SeesThroughTrimmedSurfaces) {
    const Handle<Geom_Surface> cylinder = make<Geom_CylindricalSurface>(left_handed(), 2.0);
    const Handle<Geom_Surface> trimmed =
        make<Geom_RectangularTrimmedSurface>(cylinder, 0.1, 2.0, -1.0, 1.0);
    EXPECT_EQ(kind_name(from_occ(trimmed).value().surface), "cylinder");
}

TEST(FromOcc, GivesPeriodicSplinesTheirKnotsAtTheEnds) {
    const Handle<Geom_Surface> torus = make<Geom_ToroidalSurface>(gp_Ax3(), 5.0, 1.0);
    const auto spline = GeomConvert::SurfaceToBSplineSurface(torus);
    ASSERT_TRUE(spline->IsUPeriodic());
    const auto ours = from_occ(Handle<Geom_Surface>(spline));
    ASSERT_TRUE(ours);
    EXPECT_LT(largest_difference(spline, *ours), 1e-13);
    EXPECT_TRUE(spline->IsUPeriodic());  // the model's own surface stays as it was
}

TEST(FromOcc, TurnsBezierPatchesIntoSplines) {
    TColgp_Array2OfPnt poles(1, 3, 1, 4);
    for (int i = 1; i <= 3; ++i) {
        for (int j = 1; j <= 4; ++j) {
            poles.SetValue(i, j, gp_Pnt(i, j, 0.2 * i * j * (i - j)));
        }
    }
    const Handle<Geom_Surface> bezier = make<Geom_BezierSurface>(poles);
    const auto ours = from_occ(bezier);
    ASSERT_TRUE(ours);
    EXPECT_LT(largest_difference(bezier, *ours), 1e-14 * 10);
}

TEST(FromOcc, HasNoClosedFormForOffsets) {
    const Handle<Geom_Surface> torus = make<Geom_ToroidalSurface>(gp_Ax3(), 5.0, 1.0);
    const auto spline = GeomConvert::SurfaceToBSplineSurface(torus);
    const Handle<Geom_Surface> offset = make<Geom_OffsetSurface>(spline, 0.5);
    EXPECT_FALSE(from_occ(offset));
}

TEST(ToOcc, IsTheInverseOfFromOcc) {
    for (const auto& surface : occt_forms(gp_Ax3(gp_Pnt(4, 0, -1), gp_Dir(1, 2, 3)))) {
        const auto back = to_occ(from_occ(surface).value().surface);
        ASSERT_TRUE(back);
        EXPECT_EQ((*back)->DynamicType(), surface->DynamicType());
        EXPECT_LT((*back)->Value(0.7, 0.3).Distance(surface->Value(0.7, 0.3)), 1e-14 * 10);
    }
}

TEST(ToOcc, KeepsRationalSplinesWithUnevenKnots) {
    const Handle<Geom_Surface> torus = make<Geom_ToroidalSurface>(left_handed(), 5.0, 1.0);
    const Surface ours =
        from_occ(Handle<Geom_Surface>(GeomConvert::SurfaceToBSplineSurface(torus))).value().surface;
    const auto& spline = std::get<SplineSurface>(ours);
    ASSERT_TRUE(spline.rational());
    ASSERT_NE(spline.count_u() * 10 + spline.degree_u, spline.count_v());
    const auto back = to_occ(ours);
    ASSERT_TRUE(back);
    for (double u = 0.0; u < 6.0; u += 0.5) {
        for (double v = 0.0; v < 6.0; v += 0.7) {
            EXPECT_LT((from_occ((*back)->Value(u, v)) - evaluate(ours, u, v).point).norm(), 1e-13);
        }
    }
}

TEST(ToOcc, RefusesADegreeThatOcctDoesNotTake) {
    SplineSurface s;
    s.degree_u = 26;
    s.degree_v = 1;
    s.knots_u.assign(27, 0.0);
    s.knots_u.insert(s.knots_u.end(), 27, 1.0);
    s.knots_v = {0, 0, 1, 1};
    s.poles = Eigen::Matrix3Xd::Zero(3, 54);
    const auto refused = to_occ(s);
    ASSERT_FALSE(refused);
    EXPECT_NE(refused.error().message.find("25"), std::string::npos);
}

}  // namespace
}  // namespace suture::occ

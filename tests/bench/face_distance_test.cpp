#include "bench/face_distance.h"

#include "bench/border_noise.h"
#include <gtest/gtest.h>

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <GeomConvert.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Wire.hxx>
#include <gp_Circ.hxx>
#include <gp_Pln.hxx>

#include <cmath>
#include <numbers>

namespace suture::bench {
namespace {

constexpr double kExact = 1e-9;

TopoDS_Wire circle(double radius) {
    const gp_Ax2 axes(gp::Origin(), gp::DZ());
    return BRepBuilderAPI_MakeWire(BRepBuilderAPI_MakeEdge(gp_Circ(axes, radius)));
}

/// A flat ring about the origin.
TopoDS_Face ring(double inner, double outer) {
    BRepBuilderAPI_MakeFace make(gp_Pln(), circle(outer));
    make.Add(TopoDS::Wire(circle(inner).Reversed()));
    return make.Face();
}

/// The eighth of a sphere between the positive axes, with a pole.
TopoDS_Face octant(double radius) {
    using std::numbers::pi;
    const TopoDS_Shape sphere = BRepPrimAPI_MakeSphere(radius, 0.0, pi / 2, pi / 2).Shape();
    for (TopExp_Explorer at(sphere, TopAbs_FACE); at.More(); at.Next()) {
        const TopoDS_Face& face = TopoDS::Face(at.Current());
        if (BRep_Tool::Surface(face)->DynamicType()->Name() ==
            std::string("Geom_SphericalSurface")) {
            return face;
        }
    }
    return {};
}

TEST(FaceDistance, RespectsTheTrimmingOfAFace) {
    FaceDistance distance(ring(2.0, 5.0));
    EXPECT_NEAR(distance({3.0, 0.0, 1.5}), 1.5, kExact);    // above the ring
    EXPECT_NEAR(distance({0.5, 0.0, 0.0}), 1.5, kExact);    // in its window
    EXPECT_NEAR(distance({0.0, 8.0, 4.0}), 5.0, kExact);    // outside of it
    EXPECT_NEAR(distance({0.0, -3.0, -2.0}), 2.0, kExact);  // below
    EXPECT_NEAR(distance({0.0, 0.0, 0.0}), 2.0, kExact);    // equally far all round
}

TEST(BorderNoise, IsHowFarEdgesLieOffTheirSurfaces) {
    const gp_Ax2 above(gp_Pnt(0.0, 0.0, 0.01), gp::DZ());
    const TopoDS_Edge off = BRepBuilderAPI_MakeEdge(gp_Circ(above, 5.0));
    EXPECT_NEAR(noise_of(off, ring(2.0, 5.0)), 0.01, kExact);
    TopoDS_Face lost;
    TopoDS_Compound open;
    const BRep_Builder builder;
    builder.MakeCompound(open);
    for (TopExp_Explorer at(BRepPrimAPI_MakeBox(3.0, 4.0, 5.0).Shape(), TopAbs_FACE); at.More();
         at.Next()) {
        if (lost.IsNull()) {
            lost = TopoDS::Face(at.Current());
        } else {
            builder.Add(open, at.Current());
        }
    }
    EXPECT_LT(border_noise(open, lost), kExact);
}

TEST(FaceDistance, IsThatToTheSphereAlsoAtItsPole) {
    FaceDistance distance(octant(3.0));
    EXPECT_NEAR(distance({1.0, 1.0, 1.0}), 3.0 - std::sqrt(3.0), kExact);
    EXPECT_NEAR(distance({0.0, 0.0, 4.0}), 1.0, kExact);
    EXPECT_NEAR(distance({4.0, 4.0, 2.0}), 3.0, kExact);
    EXPECT_NEAR(distance({0.0, 5.0, -3.0}), std::hypot(2.0, 3.0), kExact);
}

TEST(FaceDistance, OfAFaceFromItselfIsZero) {
    for (const TopoDS_Face& face : {ring(2.0, 5.0), octant(3.0)}) {
        FaceDistance distance(face);
        for (const gp_Pnt& point : points_of(face)) {
            EXPECT_NEAR(distance(point), 0.0, kExact);
        }
    }
}

TEST(PointsOf, LieInsideAndOnTheBoundary) {
    int inside = 0;
    int on_boundary = 0;
    for (const gp_Pnt& point : points_of(ring(2.0, 5.0))) {
        const double radius = point.Distance(gp::Origin());
        EXPECT_GE(radius, 2.0 - kExact);
        EXPECT_LE(radius, 5.0 + kExact);
        const bool edge = std::min(radius - 2.0, 5.0 - radius) < kExact;
        ++(edge ? on_boundary : inside);
    }
    EXPECT_GT(inside, 200);
    EXPECT_GE(on_boundary, 40);
}

}  // namespace
}  // namespace suture::bench

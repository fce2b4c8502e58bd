#include "suture/check/folds.h"

#include "suture/occ/topology.h"

#include "kernel/check/shapes.h"
#include <gtest/gtest.h>

#include <BRepBuilderAPI_Transform.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <GeomConvert.hxx>
#include <Geom_BezierCurve.hxx>
#include <Geom_ConicalSurface.hxx>
#include <Geom_RectangularTrimmedSurface.hxx>
#include <Geom_SphericalSurface.hxx>
#include <Geom_SurfaceOfLinearExtrusion.hxx>
#include <Geom_SurfaceOfRevolution.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Iterator.hxx>

#include <numeric>
#include <random>

namespace suture {
namespace {

FaceFold look(const TopoDS_Shape& shape, int face = 1) {
    const auto found = find_folds(shape, {face}, Progress{});
    EXPECT_TRUE(found) << found.error().message;
    return found ? found->front() : FaceFold{};
}

/// A planar map of the unit square, whose Jacobian's sign is that of the normal's z.
shapes::Net planar_net(int rows, int columns, const std::function<gp_Pnt2d(double, double)>& map) {
    shapes::Net net;
    for (int i = 0; i < rows; ++i) {
        net.emplace_back();
        for (int j = 0; j < columns; ++j) {
            const gp_Pnt2d p =
                map(static_cast<double>(i) / (rows - 1), static_cast<double>(j) / (columns - 1));
            net.back().emplace_back(p.X(), p.Y(), 0.0);
        }
    }
    return net;
}

double jacobian(const occ::Handle<Geom_Surface>& surface, double u, double v) {
    gp_Pnt p;
    gp_Vec du;
    gp_Vec dv;
    surface->D1(u, v, p, du, dv);
    return du.Crossed(dv).Z();
}

/// The second way: signs of the Jacobian at 200 x 200 points.
bool turns_over(const occ::Handle<Geom_Surface>& surface) {
    double least = 1e300;
    double most = -1e300;
    for (int i = 0; i <= 200; ++i) {
        for (int j = 0; j <= 200; ++j) {
            const double value = jacobian(surface, i / 200.0, j / 200.0);
            least = std::min(least, value);
            most = std::max(most, value);
        }
    }
    return least < 0.0 && most > 0.0;
}

TEST(Folds, AgreesWithDenseSamplesOnRandomPlanarMaps) {
    std::mt19937 random(7);
    int folded = 0;
    int sound = 0;
    for (int k = 0; k < 120; ++k) {
        std::normal_distribution<double> shift(0.0, 0.03 + 0.03 * (k % 4));
        const auto surface = shapes::bezier(planar_net(4, 6, [&](double u, double v) {
            return gp_Pnt2d(u + shift(random), v + shift(random));
        }));
        const bool expected = turns_over(surface);
        const FaceFold found = look(shapes::face_on(surface));
        // What the samples miss may be found: a corner of the map no wider than a step of theirs.
        if (expected) {
            EXPECT_EQ(found.verdict, FoldVerdict::Fold) << k;
        } else if (found.verdict != FoldVerdict::None) {
            double least = 1e300;
            for (int i = 0; i <= 40; ++i) {
                for (int j = 0; j <= 40; ++j) {
                    const double u = std::clamp(found.uv[0] + (i - 20) * 1e-4, 0.0, 1.0);
                    const double v = std::clamp(found.uv[1] + (j - 20) * 1e-4, 0.0, 1.0);
                    least = std::min(least, std::abs(jacobian(surface, u, v)));
                }
            }
            EXPECT_LT(least, 0.01) << k;
        }
        if (found.verdict == FoldVerdict::Fold) {
            EXPECT_NEAR(found.angle, kPi, 1e-9);
            EXPECT_NEAR(jacobian(surface, found.uv[0], found.uv[1]), 0.0, 0.1);
        }
        folded += expected ? 1 : 0;
        sound += found.verdict == FoldVerdict::None ? 1 : 0;
    }
    EXPECT_GT(folded, 20);
    EXPECT_GT(sound, 20);
}

/// x = u (1 - u) or so: turns back at u = 1/2, exactly in closed form.
TEST(Folds, FindsFoldWhereTheMapTurnsBack) {
    // x'(u) = 1 - u / 0.7
    const auto surface = shapes::bezier(
        {{{0, 0, 0}, {0, 1, 0}, {0, 3, 0}},
         {{0.5, 0, 0}, {0.5, 1, 0}, {0.5, 3, 0}},
         {{1.0 - 0.5 / 0.7, 0, 0}, {1.0 - 0.5 / 0.7, 1, 0}, {1.0 - 0.5 / 0.7, 3, 0}}});
    const FaceFold found = look(shapes::face_on(surface));
    EXPECT_EQ(found.verdict, FoldVerdict::Fold);
    EXPECT_NEAR(found.uv[0], 0.7, 0.02);
    EXPECT_NEAR(found.at.x(), 0.35, 1e-3);
    EXPECT_NEAR(found.angle, kPi, 1e-9);
    EXPECT_FALSE(found.backwards);
}

TEST(Folds, LeavesOutWhatLiesOutsideTheLoops) {
    const auto surface = shapes::bezier({{{0, 0, 0}, {0, 1, 0}, {0, 3, 0}},
                                         {{0.5, 0, 0}, {0.5, 1, 0}, {0.5, 3, 0}},
                                         {{0.2, 0, 0}, {0.2, 1, 0}, {0.2, 3, 0}}});
    // x' = 1 - 1.6 u vanishes at 0.625.
    const auto part = [&](double to) {
        return look(BRepBuilderAPI_MakeFace(surface, 0.0, to, 0.0, 1.0, 1e-7).Face()).verdict;
    };
    EXPECT_EQ(part(0.6), FoldVerdict::None);
    EXPECT_EQ(part(0.65), FoldVerdict::Fold);
    // It ends where it would turn back: singular on its border, and no fold.
    EXPECT_NE(part(0.625), FoldVerdict::Fold);
}

TEST(Folds, PassesWideTurnsAndPoles) {
    const auto half_ball = occ::make<Geom_RectangularTrimmedSurface>(
        occ::make<Geom_SphericalSurface>(gp_Ax3(gp::XOY()), 5.0), 0.0, 2.0 * kPi, 0.0, 0.5 * kPi);
    EXPECT_EQ(look(shapes::face_on(half_ball)).verdict, FoldVerdict::None);
    const auto spline = GeomConvert::SurfaceToBSplineSurface(half_ball);
    EXPECT_EQ(look(shapes::face_on(spline)).verdict, FoldVerdict::None);
    const auto ball =
        GeomConvert::SurfaceToBSplineSurface(occ::make<Geom_RectangularTrimmedSurface>(
            occ::make<Geom_SphericalSurface>(gp_Ax3(gp::XOY()), 5.0), 0.0, 2.0 * kPi, -0.5 * kPi,
            0.5 * kPi));
    EXPECT_EQ(look(shapes::face_on(ball)).verdict, FoldVerdict::None);
    const auto torus = BRepPrimAPI_MakeTorus(5.0, 2.0).Shape();
    EXPECT_EQ(look(torus).verdict, FoldVerdict::None);
    const TopoDS_Shape capsule = shapes::capsule(3.0);
    EXPECT_EQ(look(capsule, 1).verdict, FoldVerdict::None);
    EXPECT_EQ(look(capsule, 2).verdict, FoldVerdict::None);
}

/// A U of half-circles' Bezier control polygon: turning through 180 degrees within its `width`.
TopoDS_Face hairpin(double width) {
    TColgp_Array1OfPnt net(1, 6);
    net(1) = {0, 0, 0};
    net(2) = {20, 0, 0};
    net(3) = {40, 0, 0};
    net(4) = {40, 0, width};
    net(5) = {20, 0, width};
    net(6) = {0, 0, width};
    const auto curve = occ::make<Geom_BezierCurve>(net);
    const auto surface = occ::make<Geom_SurfaceOfLinearExtrusion>(curve, gp::DY());
    const auto spline = GeomConvert::SurfaceToBSplineSurface(
        occ::make<Geom_RectangularTrimmedSurface>(surface, 0.0, 1.0, 0.0, 30.0));
    return shapes::face_on(spline);
}

TEST(Folds, FindsHairpinAndPassesFillet) {
    EXPECT_EQ(look(hairpin(1e-3)).verdict, FoldVerdict::Fold);
    EXPECT_EQ(look(hairpin(10.0)).verdict, FoldVerdict::None);
}

TEST(Folds, FindsCreaseThatTurnsBack) {
    const double steep = std::tan(radians(80.0));
    EXPECT_EQ(look(shapes::face_on(
                       shapes::folded_spline({-steep, -0.5 * steep, 0, -0.5 * steep, -steep})))
                  .verdict,
              FoldVerdict::Fold);
    EXPECT_EQ(look(shapes::face_on(shapes::folded_spline({0.5, 0.25, 0, 0.25, 0.5}))).verdict,
              FoldVerdict::None);
}

TEST(Folds, FindsConeBeyondItsApexAndCurveBeyondItsAxis) {
    const auto cone = occ::make<Geom_ConicalSurface>(gp_Ax3(gp::XOY()), radians(30.0), 2.0);
    const double apex = -2.0 / std::sin(radians(30.0));
    const auto part = [&](double from) {
        return look(BRepBuilderAPI_MakeFace(cone, 0.0, 2.0, from, 1.0, 1e-7).Face()).verdict;
    };
    EXPECT_EQ(part(apex), FoldVerdict::None);
    EXPECT_EQ(part(apex - 1.0), FoldVerdict::Fold);
    TColgp_Array1OfPnt net(1, 3);
    const auto turned = [&](double end) {
        net(1) = {3, 0, 0};
        net(2) = {1, 0, 2};
        net(3) = {end, 0, 3};
        const auto surface =
            occ::make<Geom_SurfaceOfRevolution>(occ::make<Geom_BezierCurve>(net), gp_Ax1());
        return look(BRepBuilderAPI_MakeFace(surface, 0.0, 1.0, 0.0, 1.0, 1e-7).Face()).verdict;
    };
    EXPECT_EQ(turned(0.5), FoldVerdict::None);
    EXPECT_EQ(turned(0.0), FoldVerdict::None);
    EXPECT_NE(turned(-0.5), FoldVerdict::None);
}

TEST(Folds, FindsLoopsThatRunTheWrongWay) {
    const auto surface = shapes::height_field(0, 1, 3, 2, [](int i, int j) { return 0.1 * i * j; });
    const TopoDS_Face face = shapes::face_on(surface);
    EXPECT_FALSE(look(face).backwards);
    EXPECT_FALSE(look(face.Reversed()).backwards);
    TopoDS_Shape turned = face.EmptyCopied();
    for (TopoDS_Iterator it(face); it.More(); it.Next()) {
        BRep_Builder().Add(turned, it.Value().Reversed());
    }
    EXPECT_TRUE(look(turned).backwards);
}

TEST(Folds, DoesNotDependOnPlaceSizeOrOrientation) {
    const auto fold = shapes::face_on(shapes::bezier(planar_net(4, 6, [](double u, double v) {
        return gp_Pnt2d(u - 1.2 * std::exp(-20.0 * ((u - 0.4) * (u - 0.4) + (v - 0.5) * (v - 0.5))),
                        v);
    })));
    const auto sound = hairpin(10.0);
    const TopoDS_Shape both = shapes::compound({fold, sound});
    for (const double factor : {1.0, 1e-3, 1e3}) {
        gp_Trsf turn;
        turn.SetRotation(gp_Ax1({1, 2, 3}, {0.3, -0.5, 0.8}), 1.234);
        gp_Trsf scale;
        scale.SetScale({1, 2, 3}, factor);
        const auto copied = BRepBuilderAPI_Transform(both, scale * turn, Standard_True).Shape();
        const auto located =
            both.Located(TopLoc_Location(scale * turn), /*theRaiseExc=*/Standard_False);
        for (const TopoDS_Shape& shape : {copied, located, copied.Reversed()}) {
            EXPECT_EQ(look(shape, 1).verdict, FoldVerdict::Fold) << factor;
            EXPECT_EQ(look(shape, 2).verdict, FoldVerdict::None) << factor;
        }
    }
}

TEST(Folds, RefusesWhatIsNotThere) {
    EXPECT_FALSE(find_folds({}, {}, {}));
    EXPECT_FALSE(find_folds(hairpin(10.0), {2}, {}));
}

}  // namespace
}  // namespace suture

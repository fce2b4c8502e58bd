#include "suture/check/continuity.h"

#include "suture/occ/topology.h"

#include "kernel/check/shapes.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <BRepAlgoAPI_Splitter.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <GeomConvert.hxx>
#include <Geom_RectangularTrimmedSurface.hxx>
#include <Geom_SphericalSurface.hxx>
#include <TopTools_ListOfShape.hxx>

#include <algorithm>
#include <array>
#include <cmath>

namespace suture {
namespace {

using shapes::sewn;

ContinuityReport measure(const TopoDS_Shape& shape, const std::vector<int>& edges = {}) {
    auto report = measure_continuity(shape, Profile{}, edges, Progress{});
    EXPECT_TRUE(report) << report.error().message;
    return *report;
}

/// The only edge between two different faces.
EdgeContinuity inner_edge(const TopoDS_Shape& shape) {
    const auto report = measure(shape);
    std::vector<EdgeContinuity> inner;
    std::ranges::copy_if(report.edges, std::back_inserter(inner),
                         [](const auto& e) { return e.faces[0] != e.faces[1]; });
    EXPECT_EQ(inner.size(), 1U);
    return inner.empty() ? EdgeContinuity{} : inner.front();
}

class FoldedPlanes : public testing::TestWithParam<double> {};

TEST_P(FoldedPlanes, HaveTheAngleTheyWereBuiltWith) {
    const double angle = radians(GetParam());
    const auto edge = inner_edge(shapes::folded_planes(angle));
    EXPECT_NEAR(edge.max_angle, angle, 1e-12);
    EXPECT_NEAR(edge.mean_angle, angle, 1e-12);
    EXPECT_NEAR(edge.max_gap, 0.0, 1e-12);
    EXPECT_NEAR(edge.length, 2.0, 1e-12);
    EXPECT_EQ(edge.curvature_mismatch, 0.0);
    EXPECT_EQ(edge.edge_class, angle < radians(0.01)  ? EdgeClass::G3
                               : angle < radians(5.0) ? EdgeClass::G0
                                                      : EdgeClass::Sharp);
}
INSTANTIATE_TEST_SUITE_P(Degrees, FoldedPlanes,
                         testing::Values(0.0, 1e-3, 0.0099, 0.0101, 1.0, 4.99, 5.01, 30.0, 89.0,
                                         90.0, 150.0, 180.0));

TEST(MeasureContinuity, CallsFacesFoldedOntoEachOtherAKnifeEdge) {
    EXPECT_THAT(inner_edge(shapes::folded_planes(kPi)).note, testing::HasSubstr("knife edge"));
    EXPECT_EQ(inner_edge(shapes::folded_planes(radians(150.0))).note, "");
}

TEST(MeasureContinuity, NotesFacesWhoseOrientationsDisagree) {
    const auto faces = occ::faces_of(shapes::folded_planes(0.0));
    const auto edge = inner_edge(shapes::compound({faces[0], faces[1].Reversed()}));
    EXPECT_NEAR(edge.max_angle, kPi, 1e-12);
    EXPECT_THAT(edge.note, testing::HasSubstr("oriented inconsistently"));
}

/// Half of the parabolic cylinder z = x^2 from y = 0 to y = +-1. Its line u = 1, on y = 0, rests at
/// x = 1 for v from 1 to 2, while the others go on.
occ::Handle<Geom_BSplineSurface> resting(double side) {
    const std::array<double, 4> edge = {0.0, 1.0, 1.0, 2.0};
    TColgp_Array2OfPnt poles(1, 3, 1, 7);
    for (int span = 0; span < 3; ++span) {
        const auto x = [&](int u, int v) {
            return u == 1 ? edge[static_cast<std::size_t>(span + v)] : 2.0 * (span + v) / 3.0;
        };
        for (int i = 0; i < 3; ++i) {
            for (int j = 0; j < 3; ++j) {
                // The bilinear x and its square as polynomials of degree 2 and 2.
                double sum_x = 0.0;
                double sum_z = 0.0;
                int count = 0;
                for (int p = std::max(0, i - 1); p <= std::min(1, i); ++p) {
                    for (int q = std::max(0, j - 1); q <= std::min(1, j); ++q) {
                        sum_x += x(p, q);
                        sum_z += x(p, q) * x(i - p, j - q);
                        ++count;
                    }
                }
                poles(i + 1, 2 * span + j + 1) =
                    gp_Pnt(sum_x / count, side * (1.0 - 0.5 * i), sum_z / count);
            }
        }
    }
    TColStd_Array1OfReal u(1, 2);
    TColStd_Array1OfInteger times_u(1, 2);
    u(1) = 0.0;
    u(2) = 1.0;
    times_u.Init(3);
    TColStd_Array1OfReal v(1, 4);
    TColStd_Array1OfInteger times_v(1, 4);
    for (int k = 1; k <= 4; ++k) {
        v(k) = k - 1.0;
        times_v(k) = k == 1 || k == 4 ? 3 : 2;
    }
    return new Geom_BSplineSurface(poles, u, v, times_u, times_v, 2, 2);
}

TEST(MeasureContinuity, StaysAtTheEndOfAnEdgeWhereASurfaceRests) {
    std::vector<TopoDS_Shape> faces;
    for (const double side : {1.0, -1.0}) {
        // Next to the line that rests: there v still moves the point, by rounding.
        faces.push_back(
            BRepBuilderAPI_MakeFace(resting(side), 0.0, 1.0 - 1e-12, 0.0, 1.0, 1e-7).Face());
    }
    const auto edge = inner_edge(sewn(faces));
    EXPECT_NEAR(edge.length, std::sqrt(5.0) / 2.0 + std::asinh(2.0) / 4.0, 1e-9);
    EXPECT_NEAR(edge.max_angle, 0.0, 1e-9);
}

TEST(MeasureContinuity, PlaneIntoCylinderIsTangentWithFullCurvatureMismatch) {
    const auto edge = inner_edge(shapes::plane_into_cylinder(2.5));
    EXPECT_NEAR(edge.max_angle, 0.0, 1e-9);
    EXPECT_NEAR(edge.curvature_mismatch, 1.0, 1e-9);
    EXPECT_NEAR(edge.curvature_mismatch_sum, 1.0, 1e-9);
    EXPECT_FALSE(edge.opposite_concavity);
    EXPECT_EQ(edge.edge_class, EdgeClass::G1);
}

TEST(MeasureContinuity, HemisphereOnAPipeIsG1ForThePipeIsStraightAcrossTheRim) {
    const auto edge = inner_edge(shapes::capsule(3.0));
    EXPECT_NEAR(edge.max_gap, 0.0, 1e-9);
    EXPECT_NEAR(edge.max_angle, 0.0, 1e-9);
    EXPECT_NEAR(edge.curvature_mismatch, 1.0, 1e-9);
    EXPECT_EQ(edge.edge_class, EdgeClass::G1);
}

TEST(MeasureContinuity, ArcsOfTwoRadiiMismatchByTheirRatio) {
    // S-shaped profile: radius 1 bending left, then 4 bending left, then 2 bending right.
    BRepBuilderAPI_MakeWire profile(
        shapes::arc({1, 0, 0}, {std::sqrt(0.5), 0, std::sqrt(0.5)}, {0, 0, 1}),
        shapes::arc({0, 0, 1}, {-4 * std::sin(0.2), 0, -3 + 4 * std::cos(0.2)},
                    {-4 * std::sin(0.4), 0, -3 + 4 * std::cos(0.4)}));
    const auto edge = inner_edge(BRepPrimAPI_MakePrism(profile.Wire(), gp_Vec(0, 7, 0)).Shape());
    EXPECT_NEAR(edge.max_angle, 0.0, 1e-9);
    EXPECT_NEAR(edge.curvature_mismatch, 0.75, 1e-9);
    EXPECT_NEAR(edge.curvature_mismatch_sum, 0.6, 1e-9);
    EXPECT_FALSE(edge.opposite_concavity);
}

TEST(MeasureContinuity, TellsOppositeConcavity) {
    BRepBuilderAPI_MakeWire profile(
        shapes::arc({1, 0, 0}, {std::sqrt(0.5), 0, std::sqrt(0.5)}, {0, 0, 1}),
        shapes::arc({0, 0, 1}, {-2 * std::sin(0.2), 0, 3 - 2 * std::cos(0.2)},
                    {-2 * std::sin(0.4), 0, 3 - 2 * std::cos(0.4)}));
    const auto edge = inner_edge(BRepPrimAPI_MakePrism(profile.Wire(), gp_Vec(0, 7, 0)).Shape());
    EXPECT_NEAR(edge.max_angle, 0.0, 1e-9);
    EXPECT_TRUE(edge.opposite_concavity);
    EXPECT_NEAR(edge.curvature_mismatch, 1.5, 1e-9);
    EXPECT_NEAR(edge.curvature_mismatch_sum, 1.0, 1e-9);
}

TEST(MeasureContinuity, CylinderIntoTorusIsG1) {
    const auto edge = inner_edge(shapes::rounded_rim(5.0, 2.0));
    EXPECT_NEAR(edge.max_angle, 0.0, 1e-9);
    EXPECT_NEAR(edge.curvature_mismatch, 1.0, 1e-9);
    EXPECT_EQ(edge.edge_class, EdgeClass::G1);
}

TEST(MeasureContinuity, SphereCutAlongATiltedCircleIsSmoothEverywhere) {
    TopTools_ListOfShape sphere;
    sphere.Append(BRepPrimAPI_MakeSphere(5.0).Shell());
    TopTools_ListOfShape plane;
    plane.Append(
        BRepBuilderAPI_MakeFace(gp_Pln({0.3, 0.5, 1.0}, {0.2, 0.7, 1.0}), -20, 20, -20, 20).Face());
    BRepAlgoAPI_Splitter splitter;
    splitter.SetArguments(sphere);
    splitter.SetTools(plane);
    splitter.Build();
    const auto report = measure(splitter.Shape());
    EXPECT_GE(
        std::ranges::count_if(report.edges, [](const auto& e) { return e.faces[0] != e.faces[1]; }),
        1);
    for (const auto& edge : report.edges) {
        EXPECT_NEAR(edge.max_gap, 0.0, 1e-9) << edge.edge;
        EXPECT_NEAR(edge.max_angle, 0.0, 1e-9) << edge.edge;
        EXPECT_NEAR(edge.curvature_mismatch, 0.0, 1e-9) << edge.edge;
        EXPECT_EQ(edge.edge_class, EdgeClass::G3) << edge.edge;
        EXPECT_EQ(edge.note, "") << edge.edge;
    }
}

TEST(MeasureContinuity, PolesApexesAndSeamsOfSolidsAreMeasuredAndDegeneratedEdgesLeftOut) {
    const auto cone = measure(BRepPrimAPI_MakeCone(0.0, 3.0, 4.0).Shape());
    ASSERT_EQ(cone.edges.size(), 2U);  // seam and base circle; the apex is degenerated
    for (const auto& edge : cone.edges) {
        const bool seam = edge.faces[0] == edge.faces[1];
        // The cone's normal is 3:4 downwards off the radius, the base's is straight down or up.
        EXPECT_NEAR(edge.max_angle, seam ? 0.0 : kPi - std::acos(0.6), 1e-9);
        EXPECT_EQ(edge.note, "");
    }
    for (const auto& solid :
         {BRepPrimAPI_MakeSphere(2.0).Shape(), BRepPrimAPI_MakeTorus(5.0, 2.0).Shape()}) {
        const auto report = measure(solid);
        EXPECT_TRUE(report.free_edges.empty());
        EXPECT_FALSE(report.edges.empty());
        for (const auto& edge : report.edges) {
            EXPECT_EQ(edge.faces[0], edge.faces[1]);
            EXPECT_EQ(edge.edge_class, EdgeClass::G3);
            EXPECT_EQ(edge.note, "");
            EXPECT_NEAR(edge.max_angle, 0.0, 1e-9);
        }
    }
}

TEST(MeasureContinuity, NormalsAtAPoleOfABsplineAreFoundAsLimits) {
    // Two half domes as B-spline faces that meet along meridians into the pole, where their
    // surfaces are singular.
    const auto bspline = [](double from) {
        const auto ball = occ::make<Geom_RectangularTrimmedSurface>(
            occ::make<Geom_SphericalSurface>(gp_Ax3(), 1.0), from, from + kPi, 0.0, kPi / 2);
        return shapes::face_on(GeomConvert::SurfaceToBSplineSurface(ball));
    };
    const auto report = measure(sewn({bspline(0.0), bspline(kPi)}));
    const auto inner =
        std::ranges::count_if(report.edges, [](const auto& e) { return e.faces[0] != e.faces[1]; });
    EXPECT_EQ(inner, 2);
    for (const auto& edge : report.edges) {
        EXPECT_NEAR(edge.max_angle, 0.0, 1e-8);
        EXPECT_EQ(edge.note, "");
        EXPECT_EQ(edge.edge_class, EdgeClass::G3);
    }
}

TEST(MeasureContinuity, FindsTheCreaseOfASeam) {
    // A drop: a closed cubic that leaves its tip at 20 deg and comes back at -50 deg, extruded.
    const double rise = std::tan(radians(20.0));
    const double fall = std::tan(radians(50.0));
    shapes::Net net;
    for (const auto& p :
         {gp_Pnt(0, 0, 0), gp_Pnt(3, 3 * rise, 0), gp_Pnt(2, -2 * fall, 0), gp_Pnt(0, 0, 0)}) {
        net.push_back({p, p.Translated(gp_Vec(0, 0, 5))});
    }
    const auto report = measure(shapes::face_on(shapes::bezier(net)));
    ASSERT_EQ(report.edges.size(), 1U);
    EXPECT_EQ(report.edges[0].faces[0], report.edges[0].faces[1]);
    EXPECT_NEAR(report.edges[0].max_angle, radians(180.0 - 70.0), 1e-9);
    EXPECT_EQ(report.free_edges.size(), 2U);
}

TEST(MeasureContinuity, MeasuresAKnownStepAndAKnownSlot) {
    const double gap = 0.0125;
    const auto flat = [](double x0, double x1, double height) {
        return shapes::face_on(
            shapes::height_field(x0, x1, 2, 3, [height](int, int) { return height; }));
    };
    for (const auto& other : {flat(0.0, 1.0, gap), flat(gap, 1.0, 0.0)}) {
        const auto edge = inner_edge(sewn({flat(-1.0, 0.0, 0.0), other}, 2.0 * gap));
        EXPECT_NEAR(edge.max_gap, gap, 1e-9);
        EXPECT_LE(edge.edge_gap, gap + 1e-9);
        EXPECT_NEAR(edge.max_angle, 0.0, 1e-9);
        EXPECT_EQ(edge.edge_class, EdgeClass::G0);
    }
}

TEST(MeasureContinuity, FindsTheNearestPointOnTheBorderOfAShearedPatch) {
    const double gap = 0.0125;
    shapes::Net sheared;
    for (const double x : {0.0, 0.5, 1.0}) {
        sheared.push_back({{gap + x, 0.7 * x, 0}, {gap + x, 2 + 0.7 * x, 0}});
    }
    const auto flat =
        shapes::face_on(shapes::height_field(-1, 0, 2, 3, [](int, int) { return 0.0; }));
    const auto edge = inner_edge(sewn({flat, shapes::face_on(shapes::bezier(sheared))}, 2.0 * gap));
    EXPECT_NEAR(edge.max_gap, gap, 1e-9);
}

TEST(MeasureContinuity, ComparesNoCurvaturesThatTurnTheFacesByLessThanAnAngleNobodySees) {
    // Per unit of edge length the wide cylinder turns by 2e-5 and 2e-4 rad; the limit is 1e-4.
    EXPECT_EQ(inner_edge(shapes::plane_into_cylinder(7.0 / 2e-5)).curvature_mismatch, 0.0);
    EXPECT_EQ(inner_edge(shapes::plane_into_cylinder(7.0 / 2e-5)).edge_class, EdgeClass::G3);
    EXPECT_NEAR(inner_edge(shapes::plane_into_cylinder(7.0 / 2e-4)).curvature_mismatch, 1.0, 1e-9);
}

TEST(MeasureContinuity, FindsTheLargestGapBetweenSamplesAndWhere) {
    // The step's height is a quintic in y with one peak off every even division.
    const std::array<double, 6> ordinates = {0.0, 2e-3, 9e-3, 1e-3, 0.0, 0.0};
    const auto height = [&](double s) {
        double sum = 0.0;
        const std::array<double, 6> binomials = {1, 5, 10, 10, 5, 1};
        for (int j = 0; j < 6; ++j) {
            sum += binomials.at(j) * std::pow(s, j) * std::pow(1 - s, 5 - j) * ordinates.at(j);
        }
        return sum;
    };
    double peak = 0.0;
    double peak_at = 0.0;
    for (int k = 0; k <= 100000; ++k) {
        if (height(k * 1e-5) > peak) {
            peak = height(k * 1e-5);
            peak_at = 2.0 * k * 1e-5;
        }
    }
    const auto low =
        shapes::face_on(shapes::height_field(-1, 0, 1, 5, [](int, int) { return 0.; }));
    const auto high = shapes::face_on(
        shapes::height_field(0, 1, 2, 5, [&](int, int j) { return ordinates.at(j); }));
    const auto edge = inner_edge(sewn({low, high}, 2e-2));
    EXPECT_NEAR(edge.max_gap, peak, 1e-3 * peak);
    EXPECT_NEAR(edge.gap_at.y(), peak_at, 0.02);
}

TEST(MeasureContinuity, EvaluatesCurvatureOnTheFacesSideOfAKnot) {
    // One C1 B-spline, z = 0 for x < 0 and z = x^2 for x > 0, trimmed to its right half, against a
    // flat face on its left: the curvature at x = 0 is 2 from the right and 0 from the left.
    const auto surface = shapes::folded_spline({0, 0, 0, 0, 1});
    const auto half = [&](double from, double to) {
        return BRepBuilderAPI_MakeFace(surface, from, to, 0, 2, 1e-7).Face();
    };
    const auto edge = inner_edge(sewn({half(-1, 0), half(0, 1)}));
    EXPECT_NEAR(edge.max_angle, 0.0, 1e-9);
    EXPECT_NEAR(edge.curvature_mismatch, 1.0, 1e-9);
    EXPECT_EQ(edge.edge_class, EdgeClass::G1);
    const auto flat =
        shapes::face_on(shapes::height_field(-1, 0, 2, 1, [](int, int) { return 0.; }));
    EXPECT_NEAR(inner_edge(sewn({flat, half(0, 1)})).curvature_mismatch, 1.0, 1e-9);
}

TEST(MeasureContinuity, ListsFreeAndNonManifoldEdges) {
    const auto box = BRepPrimAPI_MakeBox(1, 2, 3).Shell();
    const auto faces = occ::faces_of(box);
    const std::vector<TopoDS_Shape> open(faces.begin(), faces.end() - 1);
    const auto report = measure(shapes::compound(open));
    EXPECT_EQ(report.free_edges.size(), 4U);
    EXPECT_EQ(report.edges.size(), 8U);
    EXPECT_TRUE(report.non_manifold.empty());

    const auto fold = occ::faces_of(shapes::folded_planes(1.0));
    auto third = BRepBuilderAPI_MakeFace(gp_Pln({0, 0, 0}, {1, 0, 0}));
    const auto shared = measure(shapes::compound({fold[0], fold[1]})).edges.at(0).edge;
    const auto edge = occ::edges_of(shapes::compound({fold[0], fold[1]})).at(shared - 1);
    const auto vertex = [](const gp_Pnt& p) { return BRepBuilderAPI_MakeVertex(p).Vertex(); };
    const auto v0 = TopExp::FirstVertex(edge);
    const auto v1 = TopExp::LastVertex(edge);
    const auto up = vertex({0, 1, 4});
    BRepBuilderAPI_MakeWire wire(edge, shapes::edge_between(v1, up), shapes::edge_between(up, v0));
    const auto fin = BRepBuilderAPI_MakeFace(gp_Pln({0, 0, 0}, {1, 0, 0}), wire.Wire()).Face();
    const auto three = measure(shapes::compound({fold[0], fold[1], fin}));
    EXPECT_EQ(three.non_manifold, std::vector<int>{shared});
    EXPECT_TRUE(three.edges.empty());
}

TEST(MeasureContinuity, GivesTheSameFiguresForOneEdgeAsForAll) {
    const auto shape = shapes::capsule(2.0);
    const auto all = measure(shape);
    for (const auto& expected : all.edges) {
        const auto one = measure(shape, {expected.edge});
        ASSERT_EQ(one.edges.size(), 1U);
        EXPECT_EQ(one.edges[0].edge, expected.edge);
        EXPECT_EQ(one.edges[0].faces, expected.faces);
        EXPECT_EQ(one.edges[0].max_gap, expected.max_gap);
        EXPECT_EQ(one.edges[0].max_angle, expected.max_angle);
        EXPECT_EQ(one.edges[0].curvature_mismatch, expected.curvature_mismatch);
    }
}

TEST(MeasureContinuity, RefusesEdgesThatDoNotExistAndLimitsThatAreNoLimits) {
    const auto box = BRepPrimAPI_MakeBox(1, 2, 3).Shape();
    for (const int edge : {0, -1, 13}) {
        const auto refused = measure_continuity(box, Profile{}, {edge}, Progress{});
        ASSERT_FALSE(refused);
        EXPECT_EQ(refused.error().code, ErrorCode::Usage);
        EXPECT_THAT(refused.error().message, testing::HasSubstr("Edge" + std::to_string(edge)));
    }
    Profile bad;
    bad.tolerance.angular = -1.0;
    EXPECT_EQ(measure_continuity(box, bad, {}, Progress{}).error().code, ErrorCode::Usage);
    bad = {};
    bad.sharp = std::nan("");
    EXPECT_EQ(measure_continuity(box, bad, {}, Progress{}).error().code, ErrorCode::Usage);
    EXPECT_EQ(measure_continuity({}, Profile{}, {}, Progress{}).error().code, ErrorCode::Usage);
}

TEST(MeasureContinuity, StopsWhenCancelled) {
    std::stop_source stop;
    stop.request_stop();
    const Progress progress{.report = {}, .cancel = stop.get_token()};
    const auto stopped =
        measure_continuity(BRepPrimAPI_MakeBox(1, 2, 3).Shape(), Profile{}, {}, progress);
    ASSERT_FALSE(stopped);
    EXPECT_EQ(stopped.error().code, ErrorCode::Cancelled);
}

}  // namespace
}  // namespace suture

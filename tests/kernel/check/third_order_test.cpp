#include "suture/check/continuity.h"

#include "kernel/check/shapes.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <BRepBuilderAPI_Transform.hxx>
#include <GC_MakeCircle.hxx>
#include <Geom_Ellipse.hxx>
#include <Geom_TrimmedCurve.hxx>

#include <algorithm>

namespace suture {
namespace {

EdgeContinuity inner_edge(const TopoDS_Shape& shape) {
    const auto report = measure_continuity(shape, Profile{}, {}, Progress{});
    EXPECT_TRUE(report) << report.error().message;
    const auto inner =
        std::ranges::find_if(report->edges, [](const auto& e) { return e.faces[0] != e.faces[1]; });
    EXPECT_NE(inner, report->edges.end());
    return inner == report->edges.end() ? EdgeContinuity{} : *inner;
}

/// z = c x^2/2 on [-1, 0] and z = c x^2/2 + a x^3/6 on [0, 1]: curvature c at the shared edge on
/// both sides, its change 0 and a.
TopoDS_Shape parabola_into_cubic(double c, double a) {
    const auto left = shapes::height_field(-1, 0, 3, 2, [c](int i, int) {
        return i == 0 ? c / 2 : i == 1 ? c / 6 : 0.0;
    });
    const auto right = shapes::height_field(0, 1, 3, 2, [c, a](int i, int) {
        return i == 3 ? c / 2 + a / 6 : i == 2 ? c / 6 : 0.0;
    });
    return shapes::sewn({shapes::face_on(left), shapes::face_on(right)});
}

TEST(ThirdOrder, AJumpInTheChangeOfCurvatureIsTheAngleOfTheEvolutes) {
    const auto edge = inner_edge(parabola_into_cubic(0.8, 0.3));
    EXPECT_NEAR(edge.curvature_mismatch, 0.0, 1e-9);
    EXPECT_GT(edge.g3_samples, 0);
    EXPECT_NEAR(edge.g3_mismatch, std::atan(0.3 / (0.8 * 0.8)), 1e-9);
    EXPECT_EQ(edge.edge_class, EdgeClass::G2);
    const auto same = inner_edge(parabola_into_cubic(0.8, 0.0));
    EXPECT_NEAR(same.g3_mismatch, 0.0, 1e-9);
    EXPECT_EQ(same.edge_class, EdgeClass::G3);
}

TEST(ThirdOrder, IsTheSameForMovedScaledMirroredAndReversedModels) {
    const TopoDS_Shape shape = parabola_into_cubic(0.8, 0.3);
    const double expected = std::atan(0.3 / (0.8 * 0.8));
    for (const double scale : {1.0, 1e-3, 1e3}) {
        for (const bool mirrored : {false, true}) {
            gp_Trsf turn;
            turn.SetRotation(gp_Ax1({1, 2, 3}, {1, 1, -2}), 0.7);
            gp_Trsf size;
            size.SetScale({-1, 4, 2}, scale);
            gp_Trsf mirror;
            if (mirrored) {
                mirror.SetMirror(gp_Ax2({5, 0, 1}, {0.2, 1, 0.4}));
            }
            for (const bool copied : {false, true}) {
                const TopoDS_Shape moved =
                    copied ? BRepBuilderAPI_Transform(shape, turn * size * mirror, true).Shape()
                           : shape.Moved(TopLoc_Location(turn * mirror), false);
                EXPECT_NEAR(inner_edge(moved).g3_mismatch, expected, 1e-8);
                EXPECT_NEAR(inner_edge(moved.Reversed()).g3_mismatch, expected, 1e-8);
            }
        }
    }
}

TEST(ThirdOrder, AnEllipseLeavesItsOsculatingCircleByTheChangeOfItsCurvature) {
    // Revolved about z, the profiles are normal sections perpendicular to the shared parallel.
    const double a = 3.0;
    const double b = 2.0;
    const double t = 0.6;
    const double speed = std::hypot(a * std::sin(t), b * std::cos(t));
    const double k = a * b / std::pow(speed, 3);
    const double change =
        -3.0 * a * b * (a * a - b * b) * std::sin(t) * std::cos(t) / std::pow(speed, 6);
    const gp_Ax2 frame({5, 0, 0}, {0, -1, 0}, {1, 0, 0});  // x along X, y along Z
    const auto ellipse = occ::make<Geom_Ellipse>(frame, a, b);
    gp_Pnt at;
    gp_Vec tangent;
    ellipse->D1(t, at, tangent);
    const gp_Vec inwards = gp_Vec(0, -1, 0).Crossed(tangent).Normalized();
    const gp_Pnt center = at.Translated(inwards / k);
    const auto circle =
        occ::make<Geom_Circle>(gp_Ax2(center, {0, -1, 0}, gp_Dir(gp_Vec(center, at))), 1.0 / k);
    const auto edge =
        inner_edge(shapes::revolved({BRepBuilderAPI_MakeEdge(circle, 2 * kPi - 0.5, 2 * kPi).Edge(),
                                     BRepBuilderAPI_MakeEdge(ellipse, t, t + 0.5).Edge()},
                                    1.5));
    EXPECT_NEAR(edge.max_angle, 0.0, 1e-9);
    EXPECT_NEAR(edge.curvature_mismatch, 0.0, 1e-9);
    EXPECT_NEAR(edge.g3_mismatch, std::atan(std::abs(change) / (k * k)), 1e-9);
    EXPECT_EQ(edge.edge_class, EdgeClass::G2);
}

TEST(ThirdOrder, MeansNothingWhereCurvaturesDifferOrPassThroughZero) {
    EXPECT_EQ(inner_edge(shapes::plane_into_cylinder(2.5)).g3_samples, 0);
    const auto inflexion = inner_edge(parabola_into_cubic(0.0, 0.5));
    EXPECT_EQ(inflexion.g3_samples, 0);
    EXPECT_EQ(inflexion.edge_class, EdgeClass::G2);
}

TEST(Figures, TellWhereAlongTheEdgeTheWorstPointIs) {
    // The right face is twisted about the shared edge: the angle grows linearly along y in [0, 2].
    shapes::Net twisted;
    for (const double x : {0.0, 0.5, 1.0}) {
        twisted.push_back({{x, 0, 0}, {x, 2, 0.1 * x}});
    }
    const auto flat =
        shapes::face_on(shapes::height_field(-1, 0, 2, 3, [](int, int) { return 0.0; }));
    const auto edge = inner_edge(shapes::sewn({flat, shapes::face_on(shapes::bezier(twisted))}));
    EXPECT_NEAR(edge.max_angle, std::atan(0.1), 1e-9);
    EXPECT_NEAR(edge.min_angle, 0.0, 1e-9);
    EXPECT_NEAR(std::abs(edge.angle_along - 0.5), 0.5, 1e-9);  // at one of the ends
    EXPECT_NEAR(edge.angle_at.y(), 2.0, 1e-9);
}

TEST(Figures, GiveTheDifferenceOfTheCurvaturesToo) {
    EXPECT_NEAR(inner_edge(shapes::plane_into_cylinder(2.5)).curvature_difference, 0.4, 1e-9);
}

}  // namespace
}  // namespace suture

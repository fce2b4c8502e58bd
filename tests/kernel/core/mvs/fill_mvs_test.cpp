#include "support/ribbon_zoo.h"
#include "support/trim_of.h"
#include "suture/base/tolerance.h"
#include "suture/fill/mvs.h"
#include "suture/fill/mvs/schedule.h"

#include <Eigen/Geometry>

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace suture {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

struct Measured {
    double deviation = 0.0;  // from the known surface, relative to the hole's diameter
    double gap = 0.0;        // likewise
    double angle_deg = 0.0;
    double curvature = 0.0;  // |k1 - k2| across the boundary, times the diameter
    int poles = 0;           // in the longer direction
};

struct Truth {
    zoo::Surface surface;
    Vector2d lower, upper;  // where in its parameters to look
};

// At ribbon parameters that have nothing to do with those the method fits.
Measured measure(const Hole& hole, const FillResult& result, const Truth& truth) {
    const Patch& patch = result.patches.front();
    const auto& surface = std::get<SplineSurface>(patch.surface);
    Measured m;
    m.poles = std::max(surface.count_u(), surface.count_v());
    std::vector<Vector2d> boundary;
    Vector2d mean = Vector2d::Zero();
    const std::vector<Ribbon>& ribbons = hole.loops.front().ribbons;
    for (std::size_t i = 0; i < ribbons.size(); ++i) {
        for (int k = 0; k <= 67; ++k) {
            const double s = k / 67.0;
            const RibbonPoint q = ribbons[i].at(s);
            const Vector2d uv = test::trim_of(patch, 0, i)(s);
            const SurfaceJet j = evaluate(surface, uv.x(), uv.y());
            const Vector3d n = j.u.cross(j.v).normalized();
            m.gap = std::max(m.gap, (j.point - q.point).norm() / hole.diameter);
            const double angle = std::atan2(n.cross(q.normal).norm(), n.dot(q.normal));
            m.angle_deg = std::max(m.angle_deg, degrees(angle));
            Eigen::Matrix<double, 3, 2> E;
            E << j.u, j.v;
            const Vector2d d = (E.transpose() * E).inverse() * (E.transpose() * q.inward);
            const double own = n.dot(j.uu) * d.x() * d.x() + 2.0 * n.dot(j.uv) * d.x() * d.y() +
                               n.dot(j.vv) * d.y() * d.y();
            m.curvature = std::max(
                m.curvature, std::abs(own - q.inward.dot(q.curvature * q.inward)) * hole.diameter);
            if (k % 6 == 0) {
                boundary.push_back(uv);
            }
            mean += uv;
        }
    }
    mean /= 68.0 * static_cast<double>(ribbons.size());
    for (const Vector2d& uv : boundary) {
        for (const double t : {0.0, 0.25, 0.5, 0.75, 0.95}) {
            const Vector2d x = mean + t * (uv - mean);
            const Vector3d p = evaluate(surface, x.x(), x.y()).point;
            m.deviation =
                std::max(m.deviation,
                         zoo::distance(truth.surface, p, truth.lower, truth.upper) / hole.diameter);
        }
    }
    return m;
}

Measured filled(const Hole& hole, const Truth& truth) {
    const Result<FillResult> result = fill_mvs(hole, {});
    if (!result) {
        ADD_FAILURE() << result.error().message;
        return {1.0, 1.0, 180.0, 1.0, 1000};
    }
    return measure(hole, *result, truth);
}

struct Window {
    std::string name;
    std::vector<zoo::Curve> curves;
};
std::vector<Window> windows(Vector2d centre, double r) {
    return {{"round", zoo::circle(centre, r, 1)},
            {"arcs", zoo::circle(centre, r, 4)},
            {"star", zoo::star(centre, r, 0.25, 5, 5)},
            {"octagon", zoo::regular(centre, r, 8)},
            {"concave", zoo::concave(centre, r)}};
}

Truth around(const zoo::Surface& surface, Vector2d centre, double r) {
    return {surface, centre - Vector2d::Constant(2.0 * r), centre + Vector2d::Constant(2.0 * r)};
}

void expect_exact(const Measured& m) {
    EXPECT_LT(m.deviation, 1e-5);
    EXPECT_LT(m.gap, 2e-6);
    EXPECT_LT(m.angle_deg, 0.001);
    EXPECT_LE(m.poles, 20);
}

TEST(FillMvs, GivesSpheresBackThroughWindowsOfAnyShape) {
    const zoo::Surface sphere = zoo::sphere(1.0);
    for (const Window& window : windows({0.3, 0.2}, 0.5)) {
        SCOPED_TRACE(window.name);
        expect_exact(filled(zoo::window(sphere, window.curves), around(sphere, {0.3, 0.2}, 0.5)));
    }
}

TEST(FillMvs, GivesCylindersBackThroughWindowsOfAnyShape) {
    const zoo::Surface cylinder = zoo::cylinder(1.0);
    for (const Window& window : windows({0.3, 0.2}, 0.7)) {
        SCOPED_TRACE(window.name);
        expect_exact(
            filled(zoo::window(cylinder, window.curves), around(cylinder, {0.3, 0.2}, 0.7)));
    }
}

TEST(FillMvs, ClosesASuitcaseCornerOfAnyRadiusByASphere) {
    for (const double radius : {1e-3, 1.0, 1e3}) {
        expect_exact(
            filled(zoo::suitcase_corner(radius), {zoo::sphere(radius), {-1.0, -1.0}, {3.0, 1.5}}));
    }
}

TEST(FillMvs, MeetsTheLengthToleranceOnBoxCornersOfAnySize) {
    for (const double radius : {1e-3, 1e-2, 0.1, 1.0, 10.0, 100.0, 1e3, 5e3, 1e4, 1e5}) {
        const Hole hole = zoo::suitcase_corner(radius);
        const Measured m = filled(hole, {zoo::sphere(radius), {-1.0, -1.0}, {3.0, 1.5}});
        const double gap = m.gap * hole.diameter;
        EXPECT_LT(gap, std::max(1e-7 * hole.diameter, Tolerance().linear)) << radius;
        EXPECT_LT(m.gap, 1e-5) << radius;
        EXPECT_LT(m.angle_deg, 0.01) << radius;
    }
}

TEST(FillMvs, CurvatureThatCannotBeHadCostsNothingElsewhere) {
    // The sphere of a suitcase corner has not the curvature of the cylinders beside it.
    const Truth truth{zoo::sphere(1.0), {-1.0, -1.0}, {3.0, 1.5}};
    const Measured tangent = filled(zoo::suitcase_corner(1.0), truth);
    for (const std::size_t sides : {1U, 3U}) {
        Hole hole = zoo::suitcase_corner(1.0);
        for (std::size_t i = 0; i < sides; ++i) {
            hole.loops[0].ribbons[i].continuity = Continuity::G2;
        }
        const Measured m = filled(hole, truth);
        EXPECT_LT(m.angle_deg, std::max(1.2 * tangent.angle_deg, 0.01)) << sides;
        EXPECT_LT(m.gap, std::max(1.2 * tangent.gap, 1e-5)) << sides;
    }
}

TEST(FillMvs, ClosesAPipeByAHemisphere) {
    expect_exact(filled(zoo::pipe_end(1.0, 1), {zoo::sphere(1.0), {-4.0, 0.0}, {4.0, 1.6}}));
    expect_exact(filled(zoo::pipe_end(1.0, 4), {zoo::sphere(1.0), {-4.0, 0.0}, {4.0, 1.6}}));
}

TEST(FillMvs, FillsAHalfRoundFilletWhoseNormalsSpreadOver180Degrees) {
    const zoo::Surface cylinder = zoo::cylinder(1.0);
    const Hole hole = zoo::window(cylinder, zoo::polygon({{0, 0}, {kPi, 0}, {kPi, 3}, {0, 3}}));
    expect_exact(filled(hole, {cylinder, {-1.0, -1.0}, {5.0, 4.0}}));
}

TEST(FillMvs, ClosesMoreThanAHemisphere) {
    const Measured m =
        filled(zoo::sphere_cap(1.0, -0.5, 1), {zoo::sphere(1.0), {-4.0, -1.4}, {4.0, 1.6}});
    EXPECT_LT(m.deviation, 1e-4);
    EXPECT_LT(m.gap, 5e-6);
    EXPECT_LT(m.angle_deg, 0.002);
}

TEST(FillMvs, FillsWindowsInCurvedSheetsAndBetterStillWithCurvature) {
    const std::vector<std::pair<std::string, Truth>> sheets = {
        {"torus", around(zoo::torus(3.0, 1.0), {0.3, 0.2}, 0.6)},
        {"saddle", around(zoo::saddle(1.0), {0.1, 0.05}, 0.5)},
        {"wavy sheet", around(zoo::wavy(0.1, 2.0), {0.3, 0.1}, 0.5)}};
    for (const auto& [name, truth] : sheets) {
        const Vector2d centre = 0.5 * (truth.lower + truth.upper);
        const double r = 0.25 * (truth.upper - truth.lower).x();
        for (const Continuity continuity : {Continuity::G1, Continuity::G2}) {
            SCOPED_TRACE(name + " " + std::string(to_string(continuity)));
            const Measured m =
                filled(zoo::window(truth.surface, zoo::circle(centre, r, 4), continuity), truth);
            EXPECT_LT(m.gap, 1e-5);
            EXPECT_LT(m.angle_deg, 0.005);
            EXPECT_LE(m.poles, 30);
            EXPECT_LT(m.deviation, continuity == Continuity::G1 ? 2e-3 : 5e-4);
            if (continuity == Continuity::G2) {
                EXPECT_LT(m.curvature, 1e-3);
            }
        }
    }
}

TEST(FillMvs, FillsAStrongSaddleThatTurnsBy3Pi) {
    const zoo::Surface saddle = zoo::saddle(1.0);
    const Measured m = filled(zoo::window(saddle, zoo::circle({0.0, 0.0}, 1.7, 4)),
                              {saddle, {-2.0, -2.0}, {2.0, 2.0}});
    EXPECT_LT(m.gap, 1e-5);
    EXPECT_LT(m.angle_deg, 0.005);
    EXPECT_LT(m.deviation, 1e-2);
}

TEST(FillMvs, AsksNoTangencyWhereOnlyPositionIsWanted) {
    // A planar star whose neighbours stand upright, at G0: the plane is the fairest surface.
    const zoo::Surface plane =
        zoo::graph([](const zoo::Jet&, const zoo::Jet&) { return zoo::Jet(0); });
    Hole hole = zoo::window(plane, zoo::star({0.0, 0.0}, 1.0, 0.2, 5, 5), Continuity::G0);
    expect_exact(filled(hole, {plane, {-2.0, -2.0}, {2.0, 2.0}}));
}

TEST(FillMvs, GivesTheSameBitsOnAnyNumberOfThreads) {
    // Small and large nets: a star in a wavy sheet needs more than thirty poles each way.
    for (const Hole& hole :
         {zoo::window(zoo::saddle(1.0), zoo::regular({0.1, 0.05}, 0.5, 5)),
          zoo::window(zoo::wavy(0.1, 2.0), zoo::star({0.3, 0.1}, 0.5, 0.25, 5, 5))}) {
        const auto fill_on = [&](std::size_t threads) {
            const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
            return std::get<SplineSurface>(fill_mvs(hole, {}).value().patches[0].surface);
        };
        const SplineSurface one = fill_on(1);
        for (const std::size_t threads : {2U, 2U, 5U}) {
            const SplineSurface more = fill_on(threads);
            EXPECT_TRUE(one.poles == more.poles) << threads << " threads";
            EXPECT_EQ(one.knots_u, more.knots_u);
            EXPECT_EQ(one.knots_v, more.knots_v);
        }
    }
}

// Clockwise: with the hole on the left.
std::vector<zoo::Curve> reversed(std::vector<zoo::Curve> curves) {
    std::reverse(curves.begin(), curves.end());
    for (zoo::Curve& curve : curves) {
        curve = [forward = curve](double s) {
            const auto [uv, velocity] = forward(1.0 - s);
            return std::pair<Vector2d, Vector2d>(uv, -velocity);
        };
    }
    return curves;
}

Hole with_island(Hole hole, const Hole& island) {
    hole.loops.push_back(island.loops.front());
    return hole;
}

// Rounding, amplified by a matrix whose condition is about 1e10.
constexpr double kSame = 1e-9;

// A window in a torus, with or without an island, turned, scaled and shifted.
Hole torus_window(bool island, const Eigen::Matrix3d& linear, const Vector3d& shift) {
    const zoo::Surface torus = zoo::moved(zoo::torus(3.0, 1.0), linear, shift);
    Hole hole = zoo::window(torus, zoo::regular({0.1, 0.05}, 0.5, 5));
    return island ? with_island(std::move(hole),
                                zoo::window(torus, reversed(zoo::regular({0.15, 0.1}, 0.15, 3))))
                  : hole;
}

// How far apart two fills are, along the normal: inside, the parametrisation is free. `where`: the
// same points of both domains.
double distance_between(const FillResult& a, const FillResult& b, const Vector2d& where_a,
                        const Vector2d& where_b, const Eigen::Matrix3d& linear,
                        const Vector3d& shift) {
    const SurfaceJet p =
        evaluate(std::get<SplineSurface>(a.patches[0].surface), where_a.x(), where_a.y());
    const SurfaceJet q =
        evaluate(std::get<SplineSurface>(b.patches[0].surface), where_b.x(), where_b.y());
    return std::abs(q.u.cross(q.v).normalized().dot(q.point - linear * p.point - shift));
}

TEST(FillMvs, TurnsScalesAndShiftsWithTheHole) {
    const Eigen::Matrix3d turn =
        Eigen::AngleAxisd(0.8, Vector3d(1.0, 2.0, -0.5).normalized()).toRotationMatrix();
    for (const bool island : {false, true}) {
        const Result<FillResult> plain =
            fill_mvs(torus_window(island, Eigen::Matrix3d::Identity(), Vector3d::Zero()), {});
        ASSERT_TRUE(plain) << plain.error().message;
        for (const double factor : {1e-3, 1.0, 1e3}) {
            const Eigen::Matrix3d linear = factor * turn;
            const Vector3d shift = factor * Vector3d(3.0, -1.0, 2.0);
            FillOptions options;
            options.tolerance.linear *= factor;
            const Result<FillResult> moved = fill_mvs(torus_window(island, linear, shift), options);
            ASSERT_TRUE(moved) << moved.error().message;
            for (const double s : {0.1, 0.6}) {
                EXPECT_LT(distance_between(
                              *plain, *moved, 0.8 * test::trim_of(plain->patches[0], 0, 0)(s),
                              0.8 * test::trim_of(moved->patches[0], 0, 0)(s), linear, shift),
                          kSame * factor)
                    << "scale " << factor << (island ? ", island" : "");
            }
        }
    }
}

// The same hole from the other side of the material: every loop is walked the other way.
Hole turned_over(const Hole& hole) {
    Hole result = hole;
    for (RibbonLoop& loop : result.loops) {
        std::reverse(loop.ribbons.begin(), loop.ribbons.end());
        for (Ribbon& ribbon : loop.ribbons) {
            ribbon.at = [at = ribbon.at](double s) {
                RibbonPoint p = at(1.0 - s);
                p.tangent = -p.tangent;
                p.normal = -p.normal;
                p.curvature = -p.curvature;
                return p;
            };
        }
    }
    return result;
}

TEST(FillMvs, DoesNotDependOnTheSideFromWhichTheHoleIsSeen) {
    for (const bool island : {false, true}) {
        const Hole hole = torus_window(island, Eigen::Matrix3d::Identity(), Vector3d::Zero());
        const Result<FillResult> plain = fill_mvs(hole, {});
        const Result<FillResult> turned = fill_mvs(turned_over(hole), {});
        ASSERT_TRUE(plain && turned);
        const std::size_t last = hole.loops[0].ribbons.size() - 1;
        for (const double s : {0.1, 0.6}) {
            EXPECT_LT(
                distance_between(*plain, *turned, 0.8 * test::trim_of(plain->patches[0], 0, 0)(s),
                                 0.8 * test::trim_of(turned->patches[0], 0, last)(1.0 - s),
                                 Eigen::Matrix3d::Identity(), Vector3d::Zero()),
                kSame)
                << (island ? "island" : "plain");
        }
    }
}

TEST(FillMvs, DoesNotDependOnTheStartEdge) {
    Hole hole = zoo::window(zoo::torus(3.0, 1.0), zoo::regular({0.1, 0.05}, 0.5, 5));
    const Result<FillResult> plain = fill_mvs(hole, {});
    std::vector<Ribbon>& ribbons = hole.loops[0].ribbons;
    std::rotate(ribbons.begin(), ribbons.begin() + 2, ribbons.end());
    const Result<FillResult> turned = fill_mvs(hole, {});
    ASSERT_TRUE(plain && turned);
    const Vector2d a = 0.5 * test::trim_of(plain->patches[0], 0, 2)(0.3);
    const Vector2d b = 0.5 * test::trim_of(turned->patches[0], 0, 0)(0.3);
    const SurfaceJet j = evaluate(std::get<SplineSurface>(plain->patches[0].surface), a.x(), a.y());
    const Vector3d q =
        evaluate(std::get<SplineSurface>(turned->patches[0].surface), b.x(), b.y()).point;
    EXPECT_LT(std::abs(j.u.cross(j.v).normalized().dot(j.point - q)), kSame);
}

// The largest gap and angle at an island.
std::pair<double, double> at_island(const Hole& hole, const FillResult& result) {
    const Patch& patch = result.patches.front();
    const auto& surface = std::get<SplineSurface>(patch.surface);
    double gap = 0.0;
    double angle = 0.0;
    for (std::size_t i = 0; i < hole.loops[1].ribbons.size(); ++i) {
        for (int k = 0; k <= 61; ++k) {
            const RibbonPoint q = hole.loops[1].ribbons[i].at(k / 61.0);
            const Vector2d uv = test::trim_of(patch, 1, i)(k / 61.0);
            const SurfaceJet j = evaluate(surface, uv.x(), uv.y());
            const Vector3d n = j.u.cross(j.v).normalized();
            gap = std::max(gap, (j.point - q.point).norm() / hole.diameter);
            angle = std::max(angle, std::atan2(n.cross(q.normal).norm(), n.dot(q.normal)));
        }
    }
    return {gap, degrees(angle)};
}

TEST(FillMvs, GivesASphereBackBetweenARimAndIslandsOfAnyShape) {
    const zoo::Surface sphere = zoo::sphere(1.0);
    for (const Window& window : windows({0.35, 0.22}, 0.2)) {
        SCOPED_TRACE(window.name);
        const Hole hole = with_island(zoo::window(sphere, zoo::regular({0.3, 0.2}, 0.6, 5)),
                                      zoo::window(sphere, reversed(window.curves)));
        const Result<FillResult> result = fill_mvs(hole, {});
        ASSERT_TRUE(result) << result.error().message;
        ASSERT_EQ(result->patches[0].wires.size(), 2U);
        const auto [gap, angle] = at_island(hole, *result);
        EXPECT_LT(gap, 2e-6);
        EXPECT_LT(angle, 0.001);
        expect_exact(measure(hole, *result, around(sphere, {0.3, 0.2}, 0.6)));
    }
}

TEST(FillMvs, FilletsABossOnAPlateAllTheWayAround) {
    const double boss = 1.0;
    const double fillet = 0.6;
    const zoo::Surface plate =
        zoo::graph([](const zoo::Jet& x, const zoo::Jet& y) { return 0.0 * x * y; });
    std::vector<Ribbon> foot;
    for (int k = 0; k < 2; ++k) {
        foot.push_back(zoo::ribbon(zoo::cylinder(boss),
                                   zoo::polygon({{-kPi * k, fillet}, {-kPi * (k + 1), fillet}})[0],
                                   Continuity::G1, 10 + k));
    }
    const Hole hole =
        with_island(zoo::window(plate, zoo::circle({0, 0}, boss + fillet, 3)), zoo::hole_of(foot));
    const Result<FillResult> result = fill_mvs(hole, {});
    ASSERT_TRUE(result) << result.error().message;
    const auto [gap, angle] = at_island(hole, *result);
    EXPECT_LT(gap, 1e-5);
    EXPECT_LT(angle, 0.005);
    // Near the ball-rolled fillet, a piece of a torus, in all directions.
    const Patch& patch = result->patches.front();
    const auto& surface = std::get<SplineSurface>(patch.surface);
    for (const EdgeUse& use : patch.wires[0]) {
        for (const double s : {0.1, 0.3, 0.8}) {
            const Vector2d uv = 0.8 * use.at(s);
            const Vector3d p = evaluate(surface, uv.x(), uv.y()).point;
            const Vector2d meridian(p.head<2>().norm() - boss - fillet, p.z() - fillet);
            EXPECT_NEAR(meridian.norm(), fillet, 0.06 * fillet);
        }
    }
}

TEST(FillMvs, PassesThroughInnerPoints) {
    const zoo::Surface flat =
        zoo::graph([](const zoo::Jet& x, const zoo::Jet& y) { return 0.0 * x * y; });
    Hole hole = zoo::window(flat, zoo::regular({0, 0}, 1.0, 5), Continuity::G0);
    hole.through = {{Vector3d(0.1, 0.05, 0.2)}, {Vector3d(-0.3, 0.2, 0.12)}};
    const Result<FillResult> result = fill_mvs(hole, {});
    ASSERT_TRUE(result) << result.error().message;
    const auto& surface = std::get<SplineSurface>(result->patches.front().surface);
    for (const auto& [point, normal] : hole.through) {
        double least = 1.0;
        for (int i = 0; i <= 800; ++i) {
            for (int j = 0; j <= 800; ++j) {
                const double u = surface.knots_u.front() +
                                 (surface.knots_u.back() - surface.knots_u.front()) * i / 800;
                const double v = surface.knots_v.front() +
                                 (surface.knots_v.back() - surface.knots_v.front()) * j / 800;
                const SurfaceJet x = evaluate(surface, u, v);
                const Vector3d n = x.u.cross(x.v).normalized();
                const Vector3d d = point - x.point;
                if (d.norm() < 0.005) {
                    least = std::min(least, std::abs(n.dot(d)));
                }
            }
        }
        EXPECT_LT(least, 2e-5);
    }
}

/// The surface at its point nearest to another.
SurfaceJet nearest(const SplineSurface& surface, const Vector3d& point) {
    constexpr int kGrid = 40;
    const Vector2d lower(surface.knots_u.front(), surface.knots_v.front());
    const Vector2d size = Vector2d(surface.knots_u.back(), surface.knots_v.back()) - lower;
    Vector2d uv = lower;
    const auto distance = [&](const Vector2d& at) {
        return (evaluate(surface, at.x(), at.y()).point - point).norm();
    };
    for (int i = 0; i <= kGrid; ++i) {
        for (int j = 0; j <= kGrid; ++j) {
            const Vector2d at = lower + Vector2d(i, j).cwiseProduct(size) / kGrid;
            uv = distance(at) < distance(uv) ? at : uv;
        }
    }
    for (int step = 0; step < 20; ++step) {
        const SurfaceJet x = evaluate(surface, uv.x(), uv.y());
        Eigen::Matrix<double, 3, 2> tangents;
        tangents << x.u, x.v;
        uv +=
            (tangents.transpose() * tangents).inverse() * tangents.transpose() * (point - x.point);
    }
    return evaluate(surface, uv.x(), uv.y());
}

TEST(FillMvs, HasTheNormalsThatInnerPointsAsk) {
    const zoo::Surface flat =
        zoo::graph([](const zoo::Jet& x, const zoo::Jet& y) { return 0.0 * x * y; });
    Hole hole = zoo::window(flat, zoo::regular({0, 0}, 1.0, 5), Continuity::G0);
    for (const double way : {1.0, -1.0}) {  // a normal counts either way round
        hole.through = {{Vector3d(0.1, 0.05, 0.1), way * Vector3d(0.2, 0.1, 1.0).normalized()},
                        {Vector3d(-0.3, 0.2, 0.05), Vector3d::UnitZ()}};
        const Result<FillResult> result = fill_mvs(hole, {});
        ASSERT_TRUE(result) << result.error().message;
        const auto& surface = std::get<SplineSurface>(result->patches.front().surface);
        for (const auto& [point, normal] : hole.through) {
            const SurfaceJet x = nearest(surface, point);
            EXPECT_LT((x.point - point).norm(), 2e-5);
            EXPECT_LT(x.u.cross(x.v).normalized().cross(*normal).norm(), radians(0.01));
        }
    }
}

TEST(FillMvs, RefusesALoopThatCrossesItself) {
    const Hole hole =
        zoo::window(zoo::cylinder(1.0), zoo::polygon({{0, 0}, {1, 1}, {1, 0}, {0, 1.2}}));
    const Result<FillResult> result = fill_mvs(hole, {});
    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().code, ErrorCode::Refused);
}

TEST(FillMvs, StopsWhenCancelled) {
    std::stop_source stop;
    FillOptions options;
    options.progress.cancel = stop.get_token();
    stop.request_stop();
    const Result<FillResult> result = fill_mvs(zoo::suitcase_corner(1.0), options);
    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().code, ErrorCode::Cancelled);
}

TEST(FillMvs, BeginsAgainFromAFinerNetWhereWavesAreShorterThanASpan) {
    const zoo::Surface waves = zoo::wavy(0.2, 5.0);
    const Truth truth{waves, {-0.8, -0.9}, {1.4, 1.3}};
    const Hole hole = zoo::window(waves, zoo::circle({0.3, 0.2}, 1.0, 3));
    mvs::Schedule coarse_only;
    coarse_only.fine_first_spans = coarse_only.first_spans;
    const auto both = fill_mvs(hole, {});
    const auto coarse = fill_mvs(hole, {}, coarse_only);
    ASSERT_TRUE(both && coarse);
    EXPECT_LT(measure(hole, *both, truth).angle_deg, 0.01);
    EXPECT_GT(measure(hole, *coarse, truth).angle_deg, 1.0);
}

// Comparisons with numbers that are none say that all is well.
TEST(FillMvs, RefusesNumbersThatAreNone) {
    const double none = std::numeric_limits<double>::quiet_NaN();
    for (const bool across : {true, false}) {
        Hole hole = zoo::suitcase_corner(1.0);
        Ribbon& ribbon = hole.loops[0].ribbons[1];
        ribbon.continuity = Continuity::G2;
        ribbon.edge = 17;
        ribbon.at = [at = ribbon.at, across, none](double s) {
            RibbonPoint p = at(s);
            if (s > 0.4 && s < 0.5) {
                (across ? p.inward[2] : p.curvature(1, 1)) = none;
            }
            return p;
        };
        const Result<FillResult> result = fill_mvs(hole, {});
        ASSERT_FALSE(result);
        EXPECT_EQ(result.error().code, ErrorCode::Refused);
        EXPECT_NE(result.error().message.find("edge 17"), std::string::npos)
            << result.error().message;
        EXPECT_NE(result.error().message.find("at 0.4"), std::string::npos)
            << result.error().message;
    }
}

TEST(FillMvs, EndsWhereMoreWouldBeTooMuchWork) {
    const Hole hole = zoo::fillet_corner(3, 0.6, 0.0, 0.5).setback(2.7);
    const auto poles = [](const Result<FillResult>& fill) {
        return std::get<SplineSurface>(fill->patches.front().surface).poles.cols();
    };
    const auto says = [](const Result<FillResult>& fill) {
        return std::ranges::any_of(fill->notes, [](const std::string& note) {
            return note.find("--effort thorough") != std::string::npos;
        });
    };
    FillOptions little;
    little.own["work"] = {OptionKind::Number, {0.01}, {}};
    const auto stopped = fill_mvs(hole, little);
    const auto again = fill_mvs(hole, little);
    const auto whole = fill_mvs(hole, {});
    ASSERT_TRUE(stopped && again && whole);
    EXPECT_LT(poles(stopped), poles(whole));
    EXPECT_TRUE(says(stopped));
    EXPECT_FALSE(says(whole));
    EXPECT_EQ(std::get<SplineSurface>(stopped->patches.front().surface).poles,
              std::get<SplineSurface>(again->patches.front().surface).poles);
}

}  // namespace
}  // namespace suture

#include "suture/fill/loft.h"

#include "support/windows.h"

#include <Eigen/Geometry>

#include <gtest/gtest.h>

#include <cmath>

namespace suture {
namespace {

using Eigen::Vector3d;

/// A step of height h across a gap of width w, between two plates of width 3: the plane cubic
/// through it, drawn along y. Turned and scaled; `first` is the side that the loop begins with.
Hole step(double scale, int first, double bulge = 0.0) {
    const Eigen::Matrix3d turn =
        Eigen::AngleAxisd(0.7, Vector3d(1, 2, 3).normalized()).toRotationMatrix();
    const double w = 4.0;
    const double h = 1.5;
    const auto put = [turn, scale](const Vector3d& p) -> Vector3d { return scale * (turn * p); };
    const auto profile = [w, h](double v) {
        return Vector3d(
            w * (3 * v * (1 - v) * (1 - v) / 3 + 3 * v * v * (1 - v) * 2 / 3 + v * v * v), 0,
            h * (3 * v * v * (1 - v) + v * v * v));
    };
    const auto straight = [put](Vector3d a, Vector3d b, Vector3d n) {
        return [=](double s) {
            const Vector3d t = put(b - a);
            const Vector3d normal = put(n).normalized();
            return RibbonPoint{put(a + s * (b - a)), t, normal, normal.cross(t).normalized(),
                               Eigen::Matrix3d::Zero()};
        };
    };
    const auto curved = [put, profile, bulge](double y, bool back) {
        return [=](double s) {
            const double v = back ? 1 - s : s;
            const double d = 1e-6;
            RibbonPoint p;
            p.point = put(profile(v) + Vector3d(0, y, 4 * bulge * v * (1 - v)));
            p.tangent = (back ? -1 : 1) * put(profile(v + d) - profile(v - d)) / (2 * d);
            p.normal = p.inward = Vector3d::Zero();
            p.curvature.setZero();
            return p;
        };
    };
    const std::vector<std::function<RibbonPoint(double)>> sides = {
        straight({0, 3, 0}, {0, 0, 0}, {0, 0, 1}), curved(0, false),
        straight({w, 0, h}, {w, 3, h}, {0, 0, 1}), curved(3, true)};
    Hole hole;
    auto& loop = hole.loops.emplace_back();
    for (int i = 0; i < 4; ++i) {
        const int k = (i + first) % 4;
        Ribbon ribbon;
        ribbon.at = sides[static_cast<std::size_t>(k)];
        ribbon.edge = k + 1;
        ribbon.face = k % 2 == 0 ? k + 1 : 0;
        loop.ribbons.push_back(ribbon);
    }
    hole.diameter = scale * 5.2;
    return hole;
}

TEST(FillLoft, DrawsThePlaneCubicBetweenTwoPlates) {
    for (const double scale : {1e-3, 1.0, 1e3}) {
        for (const int first : {0, 1, 2, 3}) {
            const Hole hole = step(scale, first);
            FillOptions options;
            options.tolerance.linear = 1e-6 * scale;
            const auto fill = fill_loft(hole, options);
            ASSERT_TRUE(fill) << fill.error().message;
            const Patch& patch = fill->patches.front();
            const auto& surface = std::get<SplineSurface>(patch.surface);
            EXPECT_EQ(surface.count_u(), 6);
            EXPECT_EQ(surface.count_v(), 4);
            for (const EdgeUse& use : patch.wires.front()) {
                const Ribbon& side = hole.loops[0].ribbons[static_cast<std::size_t>(use.index)];
                for (const double s : {0.0, 0.21, 0.5, 0.83, 1.0}) {
                    const RibbonPoint wanted = side.at(s);
                    const Eigen::Vector2d uv = use.at(s);
                    const SurfaceJet jet = evaluate(surface, uv.x(), uv.y());
                    EXPECT_LT((jet.point - wanted.point).norm(), 1e-9 * scale);
                    if (side.face > 0) {
                        const Vector3d normal = jet.u.cross(jet.v).normalized();
                        EXPECT_LT((normal - wanted.normal).norm(), 1e-8);
                    }
                }
            }
        }
    }
}

TEST(FillLoft, RefusesWhatIsNoBridge) {
    const auto bulged = fill_loft(step(1.0, 0, 0.05), {});
    ASSERT_FALSE(bulged);
    EXPECT_NE(bulged.error().message.find("edge 2 (no face) is 0.0"), std::string::npos)
        << bulged.error().message;
    const Plane plane{windows::tilted()};
    EXPECT_FALSE(fill_loft(windows::window_in(plane, {{0, 0}, {3, 2}, 4, false}), {}));
}

/// A closed rim of a round pipe along z: a circle that begins at an angle and has `sides` edges.
RibbonLoop round_rim(double radius, double z, double begin, bool lower, int sides) {
    RibbonLoop loop;
    const double way = lower ? 1.0 : -1.0;  // the hole is above the lower pipe
    for (int i = 0; i < sides; ++i) {
        Ribbon ribbon;
        ribbon.at = [=](double s) {
            const double turn = way * 2.0 * kPi / sides;
            const double angle = begin + turn * (i + s);
            RibbonPoint p;
            p.normal = Vector3d(std::cos(angle), std::sin(angle), 0.0);
            p.point = radius * p.normal + Vector3d(0, 0, z);
            p.tangent = radius * turn * Vector3d(-std::sin(angle), std::cos(angle), 0.0);
            p.inward = p.normal.cross(p.tangent).normalized();
            p.curvature.setZero();
            return p;
        };
        ribbon.edge = ribbon.face = i + (lower ? 1 : 11);
        loop.ribbons.push_back(ribbon);
    }
    return loop;
}

/// Every trim has to run on its side, and in the neighbour's tangent plane there.
void expect_on_sides(const Hole& hole, const FillResult& fill, double gap) {
    for (const Patch& patch : fill.patches) {
        const auto& surface = std::get<SplineSurface>(patch.surface);
        for (const EdgeUse& use : patch.wires.front()) {
            for (const double s : {0.0, 0.1, 0.37, 0.5, 0.83, 1.0}) {
                const Eigen::Vector2d uv = use.at(s);
                const SurfaceJet jet = evaluate(surface, uv.x(), uv.y());
                if (use.loop < 0) {
                    continue;
                }
                const RibbonPoint wanted = hole.loops[static_cast<std::size_t>(use.loop)]
                                               .ribbons[static_cast<std::size_t>(use.index)]
                                               .at(s);
                EXPECT_LT((jet.point - wanted.point).norm(), gap);
                if (wanted.normal.norm() > 0.5) {
                    EXPECT_LT((jet.u.cross(jet.v).normalized() - wanted.normal).norm(), 1e-5);
                }
            }
        }
    }
}

TEST(FillLoft, IsTheCylinderBetweenRimsThatBeginAnywhere) {
    for (const double begin : {0.0, 1.0, 2.9, -2.0}) {
        for (const int sides : {1, 2, 3}) {
            Hole hole;
            hole.loops = {round_rim(5, 0, 0.3, true, 1), round_rim(5, 8, begin, false, sides)};
            hole.diameter = 16;
            FillOptions options;
            options.tolerance.linear = 1e-3;
            const auto fill = fill_loft(hole, options);
            ASSERT_TRUE(fill) << fill.error().message;
            ASSERT_EQ(fill->patches.size(), 1U);
            expect_on_sides(hole, *fill, 1e-5);
            const Patch& patch = fill->patches.front();
            const auto& surface = std::get<SplineSurface>(patch.surface);
            std::vector<const EdgeUse*> seams;
            for (const EdgeUse& use : patch.wires.front()) {
                if (use.loop < 0) {
                    seams.push_back(&use);
                }
            }
            ASSERT_EQ(seams.size(), 2U);
            for (const double s : {0.0, 0.3, 0.7, 1.0}) {
                const Eigen::Vector2d a = seams[0]->at(s);
                const Eigen::Vector2d b = seams[1]->at(s);
                const Vector3d p = evaluate(surface, a.x(), a.y()).point;
                EXPECT_LT((p - evaluate(surface, b.x(), b.y()).point).norm(), 1e-5);
                EXPECT_NEAR(p.head<2>().norm(), 5.0, 1e-5);
                EXPECT_NEAR(p.z(), 8.0 * s, 1e-5);
            }
        }
    }
}

/// A square rim of a pipe along z, its sides planes.
RibbonLoop square_rim(double half, double z, bool lower, int first) {
    const std::vector<Vector3d> corners = {
        {-half, -half, z}, {half, -half, z}, {half, half, z}, {-half, half, z}};
    RibbonLoop loop;
    for (int i = 0; i < 4; ++i) {
        const int k = lower ? (first + i) % 4 : (first + 8 - i) % 4;
        const Vector3d a = corners[static_cast<std::size_t>(k)];
        const Vector3d b = corners[static_cast<std::size_t>((k + (lower ? 1 : 3)) % 4)];
        Ribbon ribbon;
        ribbon.at = [=](double s) {
            const Vector3d middle = 0.5 * (a + b) - Vector3d(0, 0, z);
            const Vector3d t = b - a;
            const Vector3d normal = middle.normalized();
            return RibbonPoint{a + s * t, t, normal, normal.cross(t).normalized(),
                               Eigen::Matrix3d::Zero()};
        };
        ribbon.edge = ribbon.face = i + (lower ? 1 : 11);
        loop.ribbons.push_back(ribbon);
    }
    return loop;
}

TEST(FillLoft, RunsFromCornerToCornerBetweenSquareRims) {
    for (const int first : {0, 1, 2, 3}) {
        Hole hole;
        hole.loops = {square_rim(5, 0, true, 0), square_rim(5, 10, false, first)};
        hole.diameter = 20;
        const auto fill = fill_loft(hole, {});
        ASSERT_TRUE(fill) << fill.error().message;
        EXPECT_EQ(fill->patches.size(), 4U);
        EXPECT_EQ(fill->inner_edges.size(), 4U);
        expect_on_sides(hole, *fill, 1e-9);
        for (const Patch& patch : fill->patches) {
            const auto& surface = std::get<SplineSurface>(patch.surface);
            const Vector3d p = evaluate(surface, 0.4, 0.6).point;
            EXPECT_NEAR(p.head<2>().cwiseAbs().maxCoeff(), 5.0, 1e-9);
        }
    }
}

TEST(FillLoft, RefusesRimsWithDifferentNumbersOfCorners) {
    Hole hole;
    hole.loops = {square_rim(5, 0, true, 0), round_rim(5, 8, 0, false, 1)};
    const auto fill = fill_loft(hole, {});
    ASSERT_FALSE(fill);
    EXPECT_NE(fill.error().message.find("4 and 0 corners"), std::string::npos);
}

}  // namespace
}  // namespace suture

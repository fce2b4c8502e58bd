#include "suture/fill/loft.h"

#include "support/windows.h"

#include <Eigen/Geometry>

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace suture

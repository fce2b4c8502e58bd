#include "suture/fill/plane.h"

#include "support/windows.h"

#include <gtest/gtest.h>

namespace suture {
namespace {

using windows::tilted;
using windows::Window;

TEST(FillPlane, ClosesAPlanarLoopAtAnyScaleAndOrientation) {
    for (const double scale : {1e-3, 1.0, 1e3}) {
        for (const bool reversed : {false, true}) {
            const Plane plane{tilted(scale)};
            const Window w{scale * Eigen::Vector2d(4, -2), scale * Eigen::Vector2d(3, 1), 5,
                           reversed};
            const Hole hole = windows::window_in(plane, w);
            const auto fill = fill_plane(hole, {});
            ASSERT_TRUE(fill) << fill.error().message;
            const auto fit = windows::fit_of(hole, fill->patches.front());
            EXPECT_LT(fit.gap, 1e-14 * 10 * scale);
            EXPECT_LT(fit.angle, 1e-13);
        }
    }
}

TEST(FillPlane, CapsADuctWithItsOutsideOutwards) {
    // The end of a pipe along +z: the neighbours' normals point away from the axis.
    const Cylinder pipe{tilted(), 2.0};
    Hole hole;
    auto& loop = hole.loops.emplace_back();
    for (int side = 0; side < 3; ++side) {
        Ribbon r;
        r.edge = side + 1;
        r.at = [pipe, side](double s) {
            const double u = 2.0 * kPi / 3.0 * (side + s);
            const SurfaceJet jet = evaluate(Surface(pipe), u, 5.0);
            return RibbonPoint{jet.point, jet.u * 2.0 * kPi / 3.0, jet.u.cross(jet.v).normalized(),
                               jet.v, Eigen::Matrix3d::Zero()};
        };
        loop.ribbons.push_back(r);
    }
    hole.diameter = windows::diameter_of(hole);
    const auto fill = fill_plane(hole, {});
    ASSERT_TRUE(fill) << fill.error().message;
    EXPECT_LT((std::get<Plane>(fill->patches.front().surface).frame.z - tilted().z).norm(), 1e-12);
}

TEST(FillPlane, RefusesALoopThatLeavesItsPlaneNamingTheWorstSide) {
    const Plane plane{tilted()};
    Hole hole = windows::window_in(plane, {{0, 0}, {3, 2}, 4, false});
    auto& ribbon = hole.loops[0].ribbons[2];
    ribbon.at = [at = ribbon.at, n = plane.frame.z](double s) {
        RibbonPoint p = at(s);
        p.point += 0.01 * std::sin(kPi * s) * n;
        return p;
    };
    const auto fill = fill_plane(hole, {});
    ASSERT_FALSE(fill);
    EXPECT_EQ(fill.error().code, ErrorCode::Refused);
    EXPECT_NE(fill.error().message.find("edge 3 (face 3)"), std::string::npos)
        << fill.error().message;
    FillOptions loose;
    loose.tolerance.linear = 0.02;
    EXPECT_TRUE(fill_plane(hole, loose));
}

}  // namespace
}  // namespace suture

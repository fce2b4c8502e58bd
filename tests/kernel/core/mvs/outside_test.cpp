#include "suture/fill/mvs/outside.h"

#include "suture/base/tolerance.h"

#include "kernel/core/mvs/nets.h"
#include <gtest/gtest.h>

#include <cmath>

namespace suture::mvs {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

Net plane(int spans_u, int spans_v) {
    return test::net_on([](double u, double v) { return Vector3d(u, 2.0 * v, u - v); },
                        uniform_axis(-1.0, 2.0, spans_u), uniform_axis(0.0, 5.0, spans_v));
}

Eigen::Matrix2Xd disc(Vector2d centre, double radius) {
    Eigen::Matrix2Xd polygon(2, 90);
    for (int k = 0; k < 90; ++k) {
        polygon.col(k) = centre + radius * Vector2d(std::cos(k * kPi / 45), std::sin(k * kPi / 45));
    }
    return polygon;
}

Vector3d point(const Net& net, Vector2d uv) {
    const BasisRow u = basis_row(net.u, uv.x());
    const BasisRow v = basis_row(net.v, uv.y());
    return net.local_poles(u.first, v.first) * local_values(u, v);
}

TEST(SettleOutside, GoesOnStraightAndMovesNoPointOfTheFace) {
    for (const double scale : {1e-3, 1.0, 1e3}) {
        const Net flat = plane(17, 23);
        const Vector2d centre(0.4, 2.2);
        Net net = flat;
        net.poles *= scale;
        Net before = net;
        int moved = 0;
        for (Eigen::Index k = 0; k < net.poles.cols(); ++k) {
            const auto i = static_cast<double>(k % net.u.count());
            const auto j = static_cast<double>(k / net.u.count());
            // Far from the disc, whose place in the net is (0.47, 0.44).
            if (std::hypot((i - 0.5) / 22.0 - 0.47, 1.2 * (j / 28.0 - 0.44)) > 0.5) {
                net.poles.col(k) += scale * Vector3d(std::sin(7.0 * i), std::cos(5.0 * j), 3.0);
                ++moved;
            }
        }
        ASSERT_GT(moved, 20);
        settle_outside({disc(centre, 0.5)}, net);
        EXPECT_LT((net.poles - before.poles).cwiseAbs().maxCoeff(), 1e-9 * scale);
        for (int k = 0; k < 50; ++k) {
            const Vector2d uv = centre + 0.01 * k * Vector2d(std::cos(k), std::sin(k));
            EXPECT_EQ(point(net, uv), point(before, uv));
        }
    }
}

TEST(SettleOutside, LeavesANetThatIsAllInside) {
    const Net net = plane(4, 6);
    Net same = net;
    Eigen::Matrix2Xd all(2, 4);
    all << -0.99, 1.99, 1.99, -0.99, 0.01, 0.01, 4.99, 4.99;
    settle_outside({all}, same);
    EXPECT_EQ(net.poles, same.poles);
}

}  // namespace
}  // namespace suture::mvs

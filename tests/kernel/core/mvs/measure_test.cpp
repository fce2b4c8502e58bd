#include "suture/fill/mvs/measure.h"

#include "kernel/core/mvs/nets.h"
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace suture::mvs {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

Net net_on(const std::function<Vector3d(double, double)>& surface) {
    return test::net_on(surface, uniform_axis(-1.0, 1.0, 8), uniform_axis(-1.2, 1.2, 10));
}

std::vector<Eigen::Matrix2Xd> square(double half) {
    Eigen::Matrix2Xd polygon(2, 4);
    polygon << -half, half, half, -half, -half, -half, half, half;
    return {polygon};
}

TEST(Regularity, IsOneOfAPlane) {
    const Net plane = net_on([](double u, double v) { return Vector3d(2.0 * u, v, 0.3 * u); });
    EXPECT_NEAR(regularity(plane, square(0.9)), 1.0, 1e-12);
}

TEST(Regularity, IsPositiveOfABowlWhoseNormalsSpreadFar) {
    const Net bowl = net_on([](double u, double v) {
        const double r = std::hypot(u, v);
        const double s = r > 0.0 ? std::sin(1.4 * r) / r : 1.4;
        return Vector3d(s * u, s * v, std::cos(1.4 * r));
    });
    EXPECT_GT(regularity(bowl, square(0.9)), 0.01);
    EXPECT_LT(regularity(bowl, square(0.9)), 1.0);
}

TEST(Regularity, IsNegativeOfFolds) {
    for (const double depth : {0.3, 1.5, 3.0}) {
        // In the middle x runs back over some spans: the sheet lies in three layers there.
        const Net fold = net_on([&](double u, double v) {
            return Vector3d(u - depth * std::exp(-8.0 * (u * u + v * v)) * 2.0 * u, v, 0.1 * u * u);
        });
        EXPECT_EQ(regularity(fold, square(0.9)) < 0.0, 2.0 * depth > 1.0) << depth;
    }
}

TEST(Regularity, LooksOnlyInsideTheBoundary) {
    const Net fold = net_on([](double u, double v) {
        return Vector3d(u < 0.6 ? u : 1.2 - u, v, 0.0);  // turns back beyond u = 0.6
    });
    EXPECT_GT(regularity(fold, square(0.3)), 0.9);
    EXPECT_LT(regularity(fold, square(0.95)), 0.0);
}

}  // namespace
}  // namespace suture::mvs

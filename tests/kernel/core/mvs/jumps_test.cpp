#include "suture/fill/mvs/jumps.h"

#include <Eigen/Geometry>

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace suture::mvs {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double kLine = 0.3;
constexpr double kSlant = 0.4;

// The coefficients of max(0, t - kLine)^2: the polar form of the polynomial on the right.
double coefficient(const Axis& axis, int i) {
    double sum = 0.0;
    for (int a = i + 1; a <= i + kDegree; ++a) {
        for (int b = a + 1; b <= i + kDegree; ++b) {
            sum += (axis.knots[static_cast<std::size_t>(a)] - kLine) *
                   (axis.knots[static_cast<std::size_t>(b)] - kLine);
        }
    }
    return axis.knots[static_cast<std::size_t>(i + kDegree)] > kLine ? sum / 10.0 : 0.0;
}

double greville(const Axis& axis, int i) {
    double sum = 0.0;
    for (int a = i + 1; a <= i + kDegree; ++a) {
        sum += axis.knots[static_cast<std::size_t>(a)];
    }
    return sum / kDegree;
}

KnotLine line_of(int axis) {
    KnotLine line;
    line.axis = axis;
    line.at = kLine;
    return line;
}

// A slanted plane up to a line of the net, beyond it a parabolic cylinder of curvature `bend`.
Net bent_along_line(int axis, double bend) {
    const std::vector<KnotLine> lines = {line_of(axis)};
    Net net{lined_axis(-1.0, 1.2, axis == 0 ? 0.4 : 0.3, 0, lines),
            lined_axis(-1.0, 1.0, 0.5, 1, lines),
            {}};
    net.poles.resize(3, net.u.count() * net.v.count());
    const Axis& across = axis == 0 ? net.u : net.v;
    const Axis& along = axis == 0 ? net.v : net.u;
    const Eigen::Matrix3d turn = Eigen::AngleAxisd(0.7, Vector3d(1, 2, 3).normalized()).matrix();
    for (int j = 0; j < net.v.count(); ++j) {
        for (int i = 0; i < net.u.count(); ++i) {
            const int a = axis == 0 ? i : j;
            const int b = axis == 0 ? j : i;
            const double t = greville(along, b);
            // Square to the line in space it is farther by 1 / sqrt(1 + slant^2).
            const double height = 0.5 * bend * coefficient(across, a) / (1.0 + kSlant * kSlant);
            net.poles.col(i + net.u.count() * j) =
                turn * Vector3d(greville(across, a) + kSlant * t, t, height);
        }
    }
    return net;
}

Eigen::Matrix2Xd square(double half) {
    Eigen::Matrix2Xd polygon(2, 400);
    for (int k = 0; k < 400; ++k) {
        const double t = half * (2.0 * (k % 100) / 100.0 - 1.0);
        const std::vector<Vector2d> at = {{t, -half}, {half, t}, {-t, half}, {-half, -t}};
        polygon.col(k) = at[static_cast<std::size_t>(k / 100)];
    }
    return polygon;
}

TEST(Jumps, AreThoseOfACylinderBesideAPlane) {
    for (const int axis : {0, 1}) {
        for (const double bend : {-2.0, 1e-3, 5.0}) {
            EXPECT_NEAR(
                largest_jump(bent_along_line(axis, bend), {line_of(axis)}, {square(0.9)}, 0.1),
                std::abs(bend), 1e-9 * std::abs(bend))
                << axis;
        }
    }
}

TEST(Jumps, CountInTheMiddleOnly) {
    const Net net = bent_along_line(0, 2.0);
    EXPECT_GT(largest_jump(net, {line_of(0)}, {square(0.9)}, 0.55), 1.0);
    EXPECT_EQ(largest_jump(net, {line_of(0)}, {square(0.9)}, 0.65), 0.0);  // 0.6 from one side
    EXPECT_EQ(largest_jump(net, {line_of(0)}, {square(0.25)}, 0.0), 0.0);  // outside
    EXPECT_EQ(largest_jump(net, {line_of(0)}, {square(0.9), square(0.5)}, 0.35), 0.0);  // an island
}

}  // namespace
}  // namespace suture::mvs

#include "suture/check/continuity.h"

#include "kernel/check/shapes.h"
#include <gtest/gtest.h>

#include <random>

namespace suture {
namespace {

constexpr int kDegreeU = 3;
constexpr int kDegreeV = 4;
using Ordinates = std::array<std::array<double, kDegreeV + 1>, kDegreeU + 1>;

double bernstein(const std::array<double, kDegreeV + 1>& b, double s) {
    return std::pow(1 - s, 4) * b[0] + 4 * s * std::pow(1 - s, 3) * b[1] +
           6 * s * s * std::pow(1 - s, 2) * b[2] + 4 * std::pow(s, 3) * (1 - s) * b[3] +
           std::pow(s, 4) * b[4];
}
double slope(const std::array<double, kDegreeV + 1>& b, double s) {
    return 4 * (std::pow(1 - s, 3) * (b[1] - b[0]) + 3 * s * std::pow(1 - s, 2) * (b[2] - b[1]) +
                3 * s * s * (1 - s) * (b[3] - b[2]) + std::pow(s, 3) * (b[4] - b[3]));
}
double second(const std::array<double, kDegreeV + 1>& b, double s) {
    return 12 * (std::pow(1 - s, 2) * (b[2] - 2 * b[1] + b[0]) +
                 2 * s * (1 - s) * (b[3] - 2 * b[2] + b[1]) + s * s * (b[4] - 2 * b[3] + b[2]));
}

/// Closed form of a height field at the border x = 0 of its patch of width 1; y = 2 s.
struct Truth {
    Eigen::Vector3d normal;
    double across;  ///< normal curvature perpendicular to the border

    Truth(const Ordinates& z, bool at_end, double s) {
        const auto row = [&](int k) { return z.at(at_end ? kDegreeU - k : k); };
        const double sign = at_end ? -1.0 : 1.0;
        std::array<double, kDegreeV + 1> first{};
        std::array<double, kDegreeV + 1> bend{};
        for (int j = 0; j <= kDegreeV; ++j) {
            first.at(j) = sign * 3.0 * (row(1).at(j) - row(0).at(j));
            bend.at(j) = 6.0 * (row(2).at(j) - 2.0 * row(1).at(j) + row(0).at(j));
        }
        const double zx = bernstein(first, s);
        const double zy = slope(row(0), s) / 2.0;
        const double zxx = bernstein(bend, s);
        const double zxy = slope(first, s) / 2.0;
        const double zyy = second(row(0), s) / 4.0;
        normal = Eigen::Vector3d(-zx, -zy, 1.0).normalized();
        const double W = std::sqrt(1.0 + zx * zx + zy * zy);
        const double b = -zx * zy / (1.0 + zy * zy);
        across = (zxx + 2.0 * b * zxy + b * b * zyy) / W /
                 (1.0 + zx * zx + 2.0 * b * zx * zy + b * b * (1.0 + zy * zy));
    }
};

class RandomCrease : public testing::TestWithParam<int> {};

TEST_P(RandomCrease, AgreesWithTheClosedFormOfTwoHeightFields) {
    std::mt19937 random(static_cast<unsigned>(GetParam()));
    std::uniform_real_distribution<double> ordinate(-0.4, 0.4);
    Ordinates left{};
    Ordinates right{};
    for (auto* const patch : {&left, &right}) {
        for (auto& row : *patch) {
            for (auto& z : row) {
                z = ordinate(random);
            }
        }
    }
    right[0] = left[kDegreeU];
    const auto face = [](double x0, const Ordinates& z) {
        return shapes::face_on(shapes::height_field(x0, x0 + 1, kDegreeU, kDegreeV,
                                                    [&](int i, int j) { return z.at(i).at(j); }));
    };
    const auto report = measure_continuity(shapes::sewn({face(-1, left), face(0, right)}),
                                           Profile{}, {}, Progress{});
    ASSERT_TRUE(report);
    ASSERT_EQ(report->edges.size(), 1U);
    const EdgeContinuity& edge = report->edges[0];

    double angle = 0.0;
    double mismatch = 0.0;
    bool opposite = false;
    constexpr int kSteps = 20000;
    for (int k = 0; k <= kSteps; ++k) {
        const double s = static_cast<double>(k) / kSteps;
        const Truth a(left, true, s);
        const Truth b(right, false, s);
        angle =
            std::max(angle, std::atan2(a.normal.cross(b.normal).norm(), a.normal.dot(b.normal)));
        mismatch = std::max(mismatch, std::abs(a.across - b.across) /
                                          std::max(std::abs(a.across), std::abs(b.across)));
        opposite = opposite || a.across * b.across < 0.0;
    }
    EXPECT_NEAR(edge.max_gap, 0.0, 1e-12);
    EXPECT_NEAR(edge.max_angle, angle, 1e-3 * angle);
    // Where one curvature changes its sign the mismatch has kinks narrower than any sampling.
    EXPECT_NEAR(edge.curvature_mismatch, mismatch, 1e-2 * mismatch);
    EXPECT_EQ(edge.opposite_concavity, opposite);
    const double s = edge.angle_at.y() / 2.0;
    EXPECT_NEAR(std::acos(Truth(left, true, s).normal.dot(Truth(right, false, s).normal)),
                edge.max_angle, 1e-9);
}
INSTANTIATE_TEST_SUITE_P(Seeds, RandomCrease, testing::Range(1, 41));

}  // namespace
}  // namespace suture

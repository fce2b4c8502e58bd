#include "suture/fill/tube/net.h"

#include "suture/fill/tube/quality.h"
#include "suture/model/surface.h"

#include "kernel/core/tube/paper_holes.h"
#include <gtest/gtest.h>

namespace suture::tube {
namespace {

Net random_net(std::vector<double> intervals) {
    Net net(knots_across(3), Ring(std::move(intervals)));
    std::srand(7);
    net.points.setRandom();
    for (int j = 0; j < net.columns(); ++j) {
        net.point(0, j) = net.points.col(0).eval();
    }
    return net;
}

TEST(TubeNet, IsTheSameSurfaceWhenItIsCutOpen) {
    // The cut runs through a simple knot and through a double one.
    for (const std::vector<double>& intervals :
         {std::vector<double>{1.0, 0.3, 0.0, 2.0, 0.7}, {1.0, 0.3, 0.0, 2.0, 0.7, 0.0}}) {
        const Net net = random_net(intervals);
        const SplineSurface surface = to_surface(net);
        for (int k = 0; k < net.columns(); ++k) {
            for (const double x : {0.01, 0.4, 0.99}) {
                const double v = net.ring.start(k) + x * net.ring.interval(k);
                for (const double u : {0.2, 1.1, 1.9}) {
                    if (net.ring.interval(k) > 0.0) {
                        const SurfaceJet a = evaluate(net, u, k, v);
                        const SurfaceJet b = evaluate(surface, u, v);
                        EXPECT_LT((a.point - b.point).norm(), 1e-14);
                        EXPECT_LT((a.uv - b.uv).norm(), 1e-12);
                        EXPECT_LT((a.vv - b.vv).norm(), 1e-12);
                    }
                }
            }
        }
    }
}

// Rounding of 1e-15 among poles that are one point turned the normal by 0.1 deg at 1e-7 from it,
// where columns are close.
TEST(TubeNet, IsOnePointAtThePole) {
    Net net(knots_across(1), Ring({1e-5, 0.3, 7.0, 2.0, 0.7}));
    net.points.setRandom();
    const Eigen::Vector3d pole(24.055505005849657, 1.0 / 3.0, 1e-13);
    for (int j = 0; j < net.columns(); ++j) {
        net.point(0, j) = pole;
    }
    const SplineSurface surface = to_surface(net);
    for (int j = 0; j < surface.count_v(); ++j) {
        EXPECT_EQ(surface.poles.col(surface.index(0, j)), pole);
    }
}

TEST(TubeRing, TellsWhereAMeanKeepsTangentsContinuous) {
    const Ring ring({1.0, 0.3, 0.0, 2.0, 0.7});
    ASSERT_EQ(ring.doubles().size(), 1U);
    const Ring::Double corner = ring.doubles().front();
    EXPECT_EQ(corner.column, 3);
    Eigen::RowVectorXd row = Eigen::RowVectorXd::LinSpaced(5, 1.0, 3.0).array().square();
    row[3] = corner.before * row[2] + (1.0 - corner.before) * row[4];
    const auto slope = [&](int k, double v) {
        const Ring::Local local = ring.on(k, v, 1);
        double sum = 0.0;
        for (int j = 0; j < 3; ++j) {
            sum += local.basis(1, j) * row[ring.wrapped(local.first + j)];
        }
        return sum;
    };
    EXPECT_NEAR(slope(1, 1.3), slope(3, 1.3), 1e-13);
}

TEST(TubeRing, GramMatrixIsTheIntegral) {
    const Ring ring({1.0, 0.3, 0.0, 2.0, 0.7});
    const Eigen::MatrixXd gram = RealMatrix(ring.gram(1)).cast<double>();
    Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(5, 5);
    constexpr int kSteps = 20000;
    for (int q = 0; q < kSteps; ++q) {
        const Ring::Local local = ring.at(4.0 * (q + 0.5) / kSteps, 1);
        for (int r = 0; r < 3; ++r) {
            for (int c = 0; c < 3; ++c) {
                sum(ring.wrapped(local.first + r), ring.wrapped(local.first + c)) +=
                    local.basis(1, r) * local.basis(1, c) * 4.0 / kSteps;
            }
        }
    }
    EXPECT_LT((gram - sum).cwiseAbs().maxCoeff(), 2e-3);
}

TEST(TubeQuality, FindsACreaseAndAFold) {
    auto paper = paper::prepare(paper::suitcase(), 8, Functional::F3);
    const Net net = close(paper.net, paper.task)->net;
    EXPECT_TRUE(measure_creases(net).empty());
    EXPECT_LT(measure_fold(net, paper.task.closing.normal).turn, 0.3);
    EXPECT_LT(pole_deviation(net, paper.task.closing.normal, 1e-6), 1e-5);
    Net folded = net;
    for (int j = 0; j < net.columns(); ++j) {
        folded.point(2, j) = 3.0 * net.point(4, j) - 2.0 * net.point(0, j);
    }
    EXPECT_GT(measure_fold(folded, paper.task.closing.normal).turn, 1.5);
}

}  // namespace
}  // namespace suture::tube

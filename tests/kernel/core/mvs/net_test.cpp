#include "suture/fill/mvs/net.h"

#include "suture/fill/mvs/knot_lines.h"

#include "nets.h"
#include <gtest/gtest.h>

#include <cmath>

namespace suture::mvs {
namespace {

Net some_net() {
    Net net{uniform_axis(-0.5, 0.7, 4), uniform_axis(-1.0, 1.0, 6), {}};
    net.poles.resize(3, net.u.count() * net.v.count());
    for (Eigen::Index k = 0; k < net.poles.size(); ++k) {
        net.poles.data()[k] = std::sin(1.3 * static_cast<double>(k * k % 101));
    }
    return net;
}

Eigen::Vector3d point(const Net& net, double s, double t) {
    const BasisRow u = basis_row(net.u, s);
    const BasisRow v = basis_row(net.v, t);
    return net.local_poles(u.first, v.first) * local_values(u, v);
}

TEST(Net, RefinementLeavesTheSurfaceAsItIs) {
    const Net net = some_net();
    const Net finer = refine(net, halved(net.u, {true, false, false, true}),
                             halved(net.v, {false, true, true, false, false, true}));
    EXPECT_EQ(finer.u.spans(), 6);
    EXPECT_EQ(finer.v.spans(), 9);
    for (const double s : {-0.5, -0.31, 0.1, 0.69}) {
        for (const double t : {-1.0, -0.4, 0.05, 0.99}) {
            EXPECT_LT((point(net, s, t) - point(finer, s, t)).norm(), 1e-14);
        }
    }
}

TEST(Net, InterpolationKeepsWhatTheNewAxesCanBearAndIsNearElsewhere) {
    const Net coarse{uniform_axis(-0.5, 0.7, 1), uniform_axis(-1.0, 1.0, 1),
                     some_net().poles.leftCols(36)};
    const Axis u = lined_axis(-0.5, 0.7, 0.3, 0, {{0, 0.1, {}}});
    const Axis v = lined_axis(-1.0, 1.0, 0.4, 1, {{1, -0.3, {}}, {1, 0.5, {}}});
    const Net exact = interpolated(coarse, u, v);  // a polynomial
    const Net smooth = test::net_on(
        [](double a, double b) { return Eigen::Vector3d(a, b, 0.1 * std::sin(2.0 * a * b)); },
        uniform_axis(-0.5, 0.7, 7), uniform_axis(-1.0, 1.0, 9));
    const Net near = interpolated(smooth, u, v);
    for (const double s : {-0.5, -0.31, 0.1, 0.69}) {
        for (const double t : {-1.0, -0.4, 0.05, 0.99}) {
            EXPECT_LT((point(coarse, s, t) - point(exact, s, t)).norm(), 1e-12);
            EXPECT_LT((point(smooth, s, t) - point(near, s, t)).norm(), 1e-3);
        }
    }
}

TEST(Net, GaussRulesIntegratePowers) {
    for (const int points : {2, 3, 4, 6}) {
        const GaussRule& rule = gauss_rule(points);
        for (int power = 0; power < 2 * points; ++power) {
            double sum = 0.0;
            for (std::size_t k = 0; k < rule.nodes.size(); ++k) {
                sum += rule.weights[k] * std::pow(rule.nodes[k], power);
            }
            EXPECT_NEAR(sum, 1.0 / (power + 1.0), 1e-14) << points << " points, power " << power;
        }
    }
}

TEST(Net, LocalBasisHoldsTheNineDerivatives) {
    const Net net = some_net();
    const double s = 0.15;
    const double t = 0.2;
    constexpr double kStep = 1e-4;
    const BasisRow u = basis_row(net.u, s);
    const BasisRow v = basis_row(net.v, t);
    const Eigen::Matrix<double, 3, 9> X = net.local_poles(u.first, v.first) * local_basis(u, v);
    const auto derivatives = [&](double a, double b) {
        const BasisRow ua = basis_row(net.u, a);
        const BasisRow vb = basis_row(net.v, b);
        return Eigen::Matrix<double, 3, 9>(net.local_poles(ua.first, vb.first) *
                                           local_basis(ua, vb));
    };
    const auto slope = [&](int column, double du, double dv) {
        return Eigen::Vector3d((derivatives(s + du * kStep, t + dv * kStep).col(column) -
                                derivatives(s - du * kStep, t - dv * kStep).col(column)) /
                               (2.0 * kStep));
    };
    const double scale = X.rightCols<4>().norm();
    const Eigen::Vector3d xu =
        (point(net, s + kStep, t) - point(net, s - kStep, t)) / (2.0 * kStep);
    EXPECT_LT((X.col(0) - xu).norm(), 1e-6 * scale);
    EXPECT_LT((X.col(2) - slope(0, 1, 0)).norm(), 1e-6 * scale);
    EXPECT_LT((X.col(3) - slope(0, 0, 1)).norm(), 1e-6 * scale);
    EXPECT_LT((X.col(4) - slope(1, 0, 1)).norm(), 1e-6 * scale);
    EXPECT_LT((X.col(5) - slope(2, 1, 0)).norm(), 1e-4 * scale);
    EXPECT_LT((X.col(6) - slope(2, 0, 1)).norm(), 1e-4 * scale);
    EXPECT_LT((X.col(7) - slope(4, 1, 0)).norm(), 1e-4 * scale);
    EXPECT_LT((X.col(8) - slope(4, 0, 1)).norm(), 1e-4 * scale);
}

TEST(Net, GramMatricesIntegrateProducts) {
    const Axis axis = uniform_axis(0.0, 2.0, 5);
    const std::vector<Eigen::MatrixXd> gram = gram_matrices(axis);
    // The basis sums to one: so do the rows of the first matrix to the length, the others to zero.
    const std::array<double, 4> expected = {2.0, 0.0, 0.0, 0.0};
    for (std::size_t d = 0; d < 4; ++d) {
        const double sum = gram[d].col(0).sum() + 2.0 * gram[d].rightCols(kDegree).sum();
        EXPECT_NEAR(sum, expected[d], 1e-11 * gram[d].cwiseAbs().maxCoeff()) << d;
    }
}

}  // namespace
}  // namespace suture::mvs

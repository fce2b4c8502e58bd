#include "support/ribbon_zoo.h"
#include "suture/fill/concentric/boundary.h"
#include "suture/fill/concentric/complete_cubic.h"
#include "suture/fill/concentric/fit.h"
#include "suture/fill/concentric/height.h"
#include "suture/fill/concentric/lifted_axis.h"

#include <gtest/gtest.h>

/// What the lift of a map into space is made of.
namespace suture::concentric {
namespace {

using Eigen::MatrixXd;
using Eigen::Vector2d;
using Eigen::VectorXd;

double cubic(double t) {
    return 2.0 - t + 3.0 * t * t - 5.0 * t * t * t;
}

TEST(CompleteCubic, IsTheCubicItsDataAreOf) {
    for (const int spans : {1, 2, 5}) {
        const CompleteCubic complete(spans);
        MatrixXd data(1, complete.count());
        data(0, 0) = cubic(0.0);
        data(0, 1) = -1.0;
        for (int k = 1; k < spans; ++k) {
            data(0, k + 1) = cubic(static_cast<double>(k) / spans);
        }
        data(0, spans + 1) = -10.0;
        data(0, spans + 2) = cubic(1.0);
        const SplineCurve spline = complete.spline(data);
        for (const double t : {0.0, 0.23, 0.5, 0.91, 1.0}) {
            EXPECT_NEAR(evaluate(spline, t)(0, 0), cubic(t), 1e-13);
        }
        // The Greville abscissae as poles are the identity.
        SplineCurve identity = spline;
        for (int k = 0; k < complete.count(); ++k) {
            identity.poles(0, k) = complete.greville(k);
        }
        EXPECT_NEAR(evaluate(identity, 0.37)(0, 0), 0.37, 1e-14);
    }
}

TEST(FitCurve, MeetsPolynomialsBetweenBreaksExactly) {
    const auto at = [](double s) -> VectorXd {
        return Vector2d(std::abs(s - 0.5), cubic(s) + std::pow(std::max(s - 0.7, 0.0), 2));
    };
    const FittedCurve fit = fit_curve(at, {{0.0}, {0.5, 0}, {0.7, 1}, {1.0}}, 5, 1e-12);
    EXPECT_LT(fit.error, 1e-13);
    EXPECT_EQ(fit.curve.count(), 6 + 5 + 4);
}

TEST(FitCurve, HalvesOnlyTheIntervalsThatNeedIt) {
    const auto at = [](double s) -> VectorXd {
        return VectorXd::Constant(1, std::exp(-100.0 * s * s));
    };
    const FittedCurve fit = fit_curve(at, {{0.0}, {1.0}}, 5, 1e-7);
    EXPECT_LE(fit.error, 1e-7);
    int early = 0;
    for (const double knot : fit.curve.knots) {
        early += knot > 0.0 && knot < 0.5 ? 1 : 0;
    }
    EXPECT_GT(early, 5);
    EXPECT_LT(static_cast<int>(fit.curve.knots.size()) - 12 - early, early);
}

TEST(HeightField, LeavesQuadraticSurfacesAsTheyAre) {
    const auto z = [](const Vector2d& x) {
        return 0.3 - x.x() + 0.2 * x.x() * x.x() - 0.7 * x.x() * x.y() + 0.4 * x.y() * x.y();
    };
    const auto slope = [](const Vector2d& x) -> Vector2d {
        return {-1.0 + 0.4 * x.x() - 0.7 * x.y(), -0.7 * x.x() + 0.8 * x.y()};
    };
    std::vector<HeightSample> samples;
    for (int k = 0; k < 24; ++k) {
        const double a = 2.0 * kPi * k / 24;
        const Vector2d at(10.0 + 3.0 * std::cos(a), 2.0 * std::sin(a));
        const Vector2d inward(-std::cos(a), -std::sin(a));
        samples.push_back({at, z(at), k % 3 == 0 ? Vector2d(0, 0) : inward,
                           k % 3 == 0 ? 0.0 : inward.dot(slope(at))});
    }
    const HeightField field(samples);
    for (const Vector2d& x : {Vector2d(10.0, 0.0), Vector2d(11.5, 0.7), Vector2d(8.0, -0.5)}) {
        EXPECT_NEAR(field.height(x), z(x), 1e-9);
        EXPECT_LT((field.gradient(x) - slope(x)).norm(), 1e-9);
    }
}

/// Heights are splines, slopes are theirs: but for fits the axis follows the field.
TEST(LiftedAxis, HasOneTangentPlaneWhereverItIsWalked) {
    const Hole hole = zoo::window(zoo::wavy(0.1, 2.0), zoo::regular({0, 0}, 0.9, 5));
    const auto boundary = boundary_of(hole, 1e-8);
    ASSERT_TRUE(boundary) << boundary.error().message;
    const HeightField field = HeightField::over(hole, *boundary, Tolerance{});
    ConcentricCurve axis;
    axis.nodes = {{-0.4, 0.1}, {0.0, 0.0}, {0.3, 0.3}};
    axis.period = 4.0;
    axis.stops = {{0, 0.0, 0.5}, {1, 1.0, 1.0}, {2, 2.0, 2.0}, {1, 3.2, 3.2}};
    const LiftedAxis lifted(axis, field, 1e-7, 1e-5);
    EXPECT_LE(lifted.error(), 1e-7);
    const Course there{1.0, 2.0, 1, 2};
    const Course back{2.0, 3.2, 2, 1};
    for (const double part : {0.0, 0.2, 0.7, 1.0}) {
        const auto one = lifted.at(there, 1.0 + part);
        const auto two = lifted.at(back, 3.2 - 1.2 * part);
        EXPECT_NEAR(one.height, two.height, 1e-14);
        EXPECT_LT((one.gradient - two.gradient).norm(), 1e-12);
        const Vector2d at = (1.0 - part) * axis.nodes[1] + part * axis.nodes[2];
        EXPECT_NEAR(one.height, field.height(at), 1e-7);
        EXPECT_LT((one.gradient - field.gradient(at)).norm(), 2e-5);
    }
    const double h = 1e-5;
    const double rise =
        (lifted.at(there, 1.4 + h).height - lifted.at(there, 1.4 - h).height) / (2.0 * h);
    const Vector2d along = axis.nodes[2] - axis.nodes[1];
    EXPECT_NEAR(rise, lifted.at(there, 1.4).gradient.dot(along), 1e-9);
    EXPECT_EQ(lifted.at({0.0, 0.5, 0, 0}, 0.2).height, lifted.height(0));
}

}  // namespace
}  // namespace suture::concentric

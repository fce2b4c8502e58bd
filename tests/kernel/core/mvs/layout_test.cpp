#include "suture/fill/mvs/layout.h"

#include "support/ribbon_zoo.h"
#include "suture/base/tolerance.h"
#include "suture/fill/mvs/polygon.h"

#include <Eigen/Geometry>

#include <gtest/gtest.h>

#include <cmath>

namespace suture::mvs {
namespace {

Layout laid_out(const Hole& hole) {
    const Result<Layout> layout = lay_out(hole.loops.front(), hole.diameter);
    EXPECT_TRUE(layout) << layout.error().message;
    return *layout;
}

TEST(LayOut, UnrollsAHalfRoundFilletExactly) {
    const Hole hole =
        zoo::window(zoo::cylinder(2.0), zoo::polygon({{0, 0}, {kPi, 0}, {kPi, 3}, {0, 3}}));
    const Layout layout = laid_out(hole);
    EXPECT_NEAR(layout.turning, 2.0 * kPi, 1e-12);
    EXPECT_LT(layout.closing_gap, 1e-12);
    const Eigen::Vector2d size = layout.upper - layout.lower;
    EXPECT_NEAR(size.x(), 3.0, 1e-10);
    EXPECT_NEAR(size.y(), 2.0 * kPi, 1e-10);
    for (std::size_t i = 0; i < 4; ++i) {
        const Eigen::Vector2d chord = layout.curves[i].at(1.0) - layout.curves[i].at(0.0);
        EXPECT_NEAR(chord.norm(), i % 2 == 0 ? 2.0 * kPi : 3.0, 1e-10);
    }
}

TEST(LayOut, MakesADiscOfThePipesEnd) {
    const Layout layout = laid_out(zoo::pipe_end(3.0, 5));
    EXPECT_NEAR(layout.turning, 0.0, 1e-12);
    for (const DomainCurve& curve : layout.curves) {
        for (const double s : {0.0, 0.4, 0.9}) {
            EXPECT_NEAR(curve.at(s).norm(), 3.0, 0.06);  // the box's centre need not be the disc's
        }
    }
}

TEST(LayOut, TurnsAsGaussAndBonnetSay) {
    // A cap: 2 pi less the integral of the Gauss curvature, which is the cap's area / r^2.
    const double latitude = 0.4;
    const Layout layout = laid_out(zoo::sphere_cap(5.0, latitude, 3));
    EXPECT_NEAR(layout.turning, 2.0 * kPi * std::sin(latitude), 1e-10);
    // An octant: three right angles between great circles.
    EXPECT_NEAR(laid_out(zoo::suitcase_corner(1.0)).turning, 1.5 * kPi, 1e-10);
}

TEST(LayOut, ClosesKeepsLengthsAndRunsCounterclockwise) {
    const Hole hole = zoo::window(zoo::torus(3.0, 1.0), zoo::star({0.3, 0.2}, 0.6, 0.25, 5, 5));
    const Layout layout = laid_out(hole);
    EXPECT_TRUE(layout.simple);
    double area = 0.0;
    for (std::size_t i = 0; i < 5; ++i) {
        const DomainCurve& curve = layout.curves[i];
        EXPECT_LT((curve.at(1.0) - layout.curves[(i + 1) % 5].at(0.0)).norm(), 1e-9);
        for (double s = 0.005; s < 1.0; s += 0.01) {
            const double speed = hole.loops[0].ribbons[i].at(s).tangent.norm();
            EXPECT_NEAR(curve.derivative(s).norm(), speed, 1e-3 * speed);
            const Eigen::Vector2d p = curve.at(s);
            const Eigen::Vector2d d = curve.derivative(s);
            area += 0.005 * (p.x() * d.y() - p.y() * d.x());
        }
    }
    EXPECT_GT(area, 0.0);
}

/// A flat sickle: a straight side and one that leaves it and comes back to it tangentially.
Hole sickle(const Eigen::Matrix3d& turn, Continuity continuity) {
    Hole hole;
    auto& loop = hole.loops.emplace_back();
    for (const bool straight : {true, false}) {
        Ribbon ribbon;
        ribbon.edge = ribbon.face = straight ? 1 : 2;
        ribbon.continuity = continuity;
        ribbon.at = [=](double s) {
            const double x = straight ? 4.0 * s : 4.0 * (1.0 - s);
            const double slope = straight ? 0.0 : 0.02 * x * (4.0 - x) * (8.0 - 4.0 * x);
            const double y = straight ? 0.0 : 0.02 * std::pow(x * (4.0 - x), 2);
            const double along = straight ? 4.0 : -4.0;
            const Eigen::Vector3d tangent(along, along * slope, 0.0);
            return RibbonPoint{turn * Eigen::Vector3d(x, y, 0.0), turn * tangent,
                               turn * Eigen::Vector3d::UnitZ(),
                               turn * Eigen::Vector3d::UnitZ().cross(tangent).normalized(),
                               Eigen::Matrix3d::Zero()};
        };
        loop.ribbons.push_back(ribbon);
    }
    hole.diameter = 4.0;
    return hole;
}

// A cusp turns by half a turn, to the left as good as to the right for all that rounding knows.
TEST(LayOut, TurnsOutwardsAtCuspsInEveryPosition) {
    for (double angle = 0.1; angle < 6.2; angle += 0.3) {
        const Eigen::Matrix3d turn =
            Eigen::AngleAxisd(angle, Eigen::Vector3d(1.0, angle, -2.0).normalized())
                .toRotationMatrix();
        for (const Continuity continuity : {Continuity::G0, Continuity::G1}) {
            const Layout layout = laid_out(sickle(turn, continuity));
            EXPECT_NEAR(layout.turning, 2.0 * kPi, 1e-6) << angle;
            EXPECT_EQ(layout.kind, LayoutKind::Development) << angle;
            EXPECT_TRUE(layout.simple) << angle;
        }
    }
}

TEST(DomainCurve, KeepsItsDirectionAndBendWhereItsEndsAreMoved) {
    Eigen::Matrix2Xd coefficients(2, 4);
    coefficients << 0.1, 0.5, 0.02, -0.03, -0.2, 0.1, 0.07, 0.01;
    const DomainCurve curve(coefficients);
    const Eigen::Vector2d start(0.03, -0.01);
    const Eigen::Vector2d end(-0.02, 0.04);
    const DomainCurve moved = curve.with_ends_moved(start, end);
    EXPECT_LT((moved.at(0.0) - curve.at(0.0) - start).norm(), 1e-14);
    EXPECT_LT((moved.at(1.0) - curve.at(1.0) - end).norm(), 1e-14);
    EXPECT_LT((moved.at(0.5) - curve.at(0.5) - 0.5 * (start + end)).norm(), 1e-14);
    for (const double s : {0.0, 1.0}) {
        const double beside = s == 0.0 ? 1e-5 : 1.0 - 1e-5;
        EXPECT_LT((moved.derivative(s) - curve.derivative(s)).norm(), 1e-13);
        EXPECT_LT((moved.derivative(beside) - curve.derivative(beside)).norm(), 1e-9);
    }
}

TEST(LayOut, RefusesASideOfZeroLength) {
    const Hole hole =
        zoo::window(zoo::sphere(1.0), zoo::polygon({{0, 0}, {0.5, 0}, {0.5, 0}, {0.2, 0.4}}));
    const Result<Layout> layout = lay_out(hole.loops.front(), hole.diameter);
    ASSERT_FALSE(layout);
    EXPECT_EQ(layout.error().code, ErrorCode::Refused);
    EXPECT_NE(layout.error().message.find("edge 2"), std::string::npos);
}

TEST(LayOut, RefusesAnUnboundedNormal) {
    Hole hole = zoo::pipe_end(1.0, 3);
    const auto at = hole.loops[0].ribbons[1].at;
    hole.loops[0].ribbons[1].at = [at](double s) {
        RibbonPoint p = at(s);
        if (s > 0.9) {
            p.normal.setConstant(std::nan(""));
        }
        return p;
    };
    const Result<Layout> layout = lay_out(hole.loops.front(), hole.diameter);
    ASSERT_FALSE(layout);
    EXPECT_NE(layout.error().message.find("edge 2"), std::string::npos);
}

TEST(CrossesItself, TellsAnEightFromARing) {
    Eigen::Matrix2Xd eight(2, 4);
    eight << 0, 1, 0, 1, 0, 1, 1, 0;
    Eigen::Matrix2Xd ring(2, 4);
    ring << 0, 1, 1, 0, 0, 0, 1, 1;
    EXPECT_TRUE(crosses_itself(eight));
    EXPECT_FALSE(crosses_itself(ring));
}

}  // namespace
}  // namespace suture::mvs

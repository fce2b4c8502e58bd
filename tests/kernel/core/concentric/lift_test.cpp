#include "support/ribbon_zoo.h"
#include "suture/fill/concentric/assemble.h"
#include "suture/fill/concentric/boundary.h"
#include "suture/fill/concentric/fit.h"
#include "suture/fill/concentric/guide.h"
#include "suture/fill/concentric/map.h"
#include "suture/fill/concentric/radial.h"
#include "suture/fill/concentric/spokes.h"

#include <Eigen/Geometry>

#include <gtest/gtest.h>

/// What the lift of a map into space is made of.
namespace suture::concentric {
namespace {

using Eigen::MatrixXd;
using Eigen::Vector2d;
using Eigen::Vector3d;
using Eigen::VectorXd;

double cubic(double t) {
    return 2.0 - t + 3.0 * t * t - 5.0 * t * t * t;
}

double quintic(double t) {
    return cubic(t) + std::pow(t, 4) - 0.7 * std::pow(t, 5);
}

double quintic_slope(double t) {
    return -1.0 + 6.0 * t - 15.0 * t * t + 4.0 * std::pow(t, 3) - 3.5 * std::pow(t, 4);
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

/// Slopes at the ends stand for two of the interpolated values: a quintic of four spans.
TEST(FitCurve, MeetsSlopesAtTheEndsExactly) {
    const auto at = [](double s) -> VectorXd { return Vector2d(std::sin(3.0 * s), quintic(s)); };
    const auto slope = [](double s) -> VectorXd {
        return Vector2d(3.0 * std::cos(3.0 * s), quintic_slope(s));
    };
    const EndSlopes slopes{slope(0.2), slope(1.1)};
    const auto missed = [&](const SplineCurve& curve, double from, double to) {
        const double s = 0.37 * from + 0.63 * to;
        return std::abs(evaluate(curve, s)(0) - at(s)(0)) / 1e-6;
    };
    const FittedCurve fit = fit_curve(at, slopes, {{0.2}, {1.1}}, 5, missed);
    EXPECT_LE(fit.error, 1.0);
    for (const int end : {0, 1}) {
        const double s = end == 0 ? 0.2 : 1.1;
        const MatrixXd jet = evaluate(fit.curve, s, 1);
        EXPECT_LT((jet.col(0) - at(s)).norm(), 1e-14);
        EXPECT_LT((jet.col(1) - (end == 0 ? slopes.from : slopes.to)).norm(), 1e-11);
    }
    // What has the right slopes and is a quintic comes back as it was.
    for (const double s : {0.3, 0.77, 1.0}) {
        EXPECT_NEAR(evaluate(fit.curve, s)(1), quintic(s), 1e-12);
    }
    EXPECT_GT(fit.curve.count(), 6);
}

TEST(Radial, IsTheQuinticItsDataAreOf) {
    for (const std::vector<double>& breaks :
         {std::vector<double>{0.0, 1.0}, {0.0, 0.5, 1.0}, {0.0, 0.125, 0.25, 0.5, 1.0}}) {
        const Radial radial(breaks);
        const int n = radial.count();
        EXPECT_EQ(n, static_cast<int>(breaks.size()) + 4);
        MatrixXd data(2, n);
        const auto put = [&](int k, double value, double other) {
            data.col(k) = Vector2d(value, other);
        };
        put(0, quintic(0.0), 1.0);
        put(1, quintic_slope(0.0), -1.0);
        for (int k = 2; k < n - 2; ++k) {
            const double t = radial.sites()[static_cast<std::size_t>(k - 2)];
            put(k, quintic(t), 1.0 - t);
        }
        put(n - 2, quintic_slope(1.0), -1.0);
        put(n - 1, quintic(1.0), 0.0);
        const MatrixXd poles = radial.poles(data);
        EXPECT_EQ(poles.col(0), data.col(0));
        EXPECT_EQ(poles.col(n - 1), data.col(n - 1));
        for (const double t : {0.0, 0.23, 0.5, 0.91, 1.0}) {
            const MatrixXd jet = radial.evaluate(poles, t);
            EXPECT_NEAR(jet(0, 0), quintic(t), 1e-12);
            EXPECT_NEAR(jet(0, 1), quintic_slope(t), 1e-11);
            EXPECT_NEAR(jet(1, 0), 1.0 - t, 1e-13);
        }
    }
}

struct Lifted {
    Hole hole;
    Boundary boundary;
    Guide guide;
    ConcentricCurve axis;
    std::vector<Region> regions;
};

Lifted lifted(Hole hole) {
    auto boundary = boundary_of(hole, 1e-8 * hole.diameter);
    auto guide = guide_of(hole, {});
    EXPECT_TRUE(boundary && guide);
    MapOptions options;
    options.salience = 0.1;
    options.flatness = 0.02;
    options.rest_at_tips = true;
    auto map = concentric_map(guide->loop, options);
    EXPECT_TRUE(map);
    Lifted all{std::move(hole), *boundary, *guide, map->axis, {}};
    all.regions = regions_of(all.boundary, all.axis, std::nullopt);
    return all;
}

std::vector<Strip> strips_of(const Region& region) {
    std::vector<Strip> all;
    for (const Course& course : region.courses) {
        all.push_back({region.first, course, course.from, course.to});
    }
    return all;
}

Hole wavy_window(double scale) {
    return scale < 0.0 ? zoo::suitcase_corner(-scale)
                       : zoo::window(zoo::wavy(0.1 * scale, 2.0 / scale),
                                     zoo::regular({0, 0}, 0.9 * scale, 5));
}

double angle_of(const Vector3d& a, const Vector3d& b) {
    return std::atan2(a.cross(b).norm(), a.dot(b));
}

/// But for positions, which only move within the guide's plane.
TEST(Spokes, BeginWithTheSidesAndTheirTangentPlanes) {
    for (const double scale : {1.0, 1e-3, 1e3, -1.0}) {
        const Lifted all = lifted(wavy_window(scale));
        const Spokes spokes(all.hole, all.boundary, all.guide, all.axis);
        for (const Region& region : all.regions) {
            const Ribbon& ribbon =
                all.hole.loops[0].ribbons[static_cast<std::size_t>(region.first)];
            for (const Strip& strip : strips_of(region)) {
                const double s = 0.3 * strip.from + 0.7 * strip.to;
                const SpokeJet jet = spokes.jet(spokes.moving(strip, s), 0.0);
                const RibbonPoint wanted = ribbon.at(s - region.first);
                EXPECT_LT((jet.point - wanted.point).norm(), 1e-8 * all.hole.diameter);
                EXPECT_LT(angle_of(jet.s.cross(jet.t), wanted.normal), radians(1e-3));
                EXPECT_GT(jet.t.dot(wanted.inward), 0.0);
            }
        }
    }
}

TEST(Spokes, HaveTheDerivativesTheySay) {
    const Lifted all = lifted(wavy_window(1.0));
    const Spokes spokes(all.hole, all.boundary, all.guide, all.axis);
    constexpr double kH = 1e-4;
    for (const Strip& strip : strips_of(all.regions[2])) {
        for (const double part : {0.0, 0.4, 1.0}) {
            const double s = (1.0 - part) * strip.from + part * strip.to;
            const MovingSpoke spoke = spokes.moving(strip, s);
            for (const double t : {0.2, 0.7}) {
                const SpokeJet jet = spokes.jet(spoke, t);
                const Vector3d along =
                    (spokes.point(spoke.at, t + kH) - spokes.point(spoke.at, t - kH)) / (2.0 * kH);
                EXPECT_LT((jet.t - along).norm(), 1e-6);
                if (part == 0.4) {
                    const double h = kH * (strip.to - strip.from);
                    const Spoke before = spokes.at(strip, s - h);
                    const Spoke after = spokes.at(strip, s + h);
                    EXPECT_LT(
                        (jet.s - (spokes.point(after, t) - spokes.point(before, t)) / (2.0 * h))
                            .norm(),
                        1e-6);
                    EXPECT_LT(
                        (jet.st - (spokes.slope(after, t) - spokes.slope(before, t)) / (2.0 * h))
                            .norm(),
                        1e-5);
                }
            }
        }
    }
}

/// Both sides' spoke from a corner has one tangent plane, although sides bend differently.
TEST(Spokes, HaveOneTangentPlaneOnBothSidesOfASeam) {
    for (const double scale : {1.0, 1e-3, 1e3, -1.0}) {
        const Lifted all = lifted(wavy_window(scale));
        const Spokes spokes(all.hole, all.boundary, all.guide, all.axis);
        for (std::size_t i = 0; i < all.regions.size(); ++i) {
            const Strip before = strips_of(all.regions[i]).back();
            const Strip after = strips_of(all.regions[(i + 1) % all.regions.size()]).front();
            for (const double t : {0.1, 0.4, 0.8}) {
                const SpokeJet a = spokes.jet(spokes.moving(before, before.to), t);
                const SpokeJet b = spokes.jet(spokes.moving(after, after.from), t);
                EXPECT_LT((a.point - b.point).norm(), 1e-9 * all.hole.diameter);
                EXPECT_LT(angle_of(a.s.cross(a.t), b.s.cross(b.t)), radians(2e-3));
            }
        }
    }
}

}  // namespace
}  // namespace suture::concentric

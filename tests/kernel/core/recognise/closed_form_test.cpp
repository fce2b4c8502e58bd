#include "support/ribbon_zoo.h"
#include "support/windows.h"
#include "suture/fill/recognise.h"

#include "kernel/core/recognise/closed_forms.h"
#include <gtest/gtest.h>

#include <algorithm>

namespace suture {
namespace {

using closed_forms::sizes;
using closed_forms::Truth;
using closed_forms::truths;
using closed_forms::without_supports;
using Eigen::Vector3d;
using windows::tilted;

/// The hole moved as a whole.
Hole moved(Hole hole, const Vector3d& by) {
    for (RibbonLoop& loop : hole.loops) {
        for (Ribbon& ribbon : loop.ribbons) {
            ribbon.at = [at = ribbon.at, by](double s) {
                RibbonPoint p = at(s);
                p.point += by;
                return p;
            };
        }
    }
    return hole;
}

TEST(FillRecognise, FindsEveryClosedFormByNormalsAlone) {
    for (const double scale : {1e-3, 1.0, 1e3}) {
        for (const bool reversed : {false, true}) {
            for (const Truth& truth : truths(scale, reversed)) {
                const Hole hole = without_supports(windows::window_in(truth.surface, truth.window));
                const auto fill = fill_recognise(hole, {});
                ASSERT_TRUE(fill) << kind_name(truth.surface) << ": " << fill.error().message;
                const Patch& patch = fill->patches.front();
                ASSERT_EQ(kind_name(patch.surface), kind_name(truth.surface));
                EXPECT_EQ(patch.reversed, reversed);
                EXPECT_LT(windows::fit_of(hole, patch).gap, 1e-11 * scale);
                EXPECT_LT(windows::fit_of(hole, patch).angle, 1e-9);
                const auto found = sizes(patch.surface);
                const auto real = sizes(truth.surface);
                for (std::size_t i = 0; i < real.size(); ++i) {
                    EXPECT_NEAR(found[i], real[i], 1e-9 * real[i]) << kind_name(truth.surface);
                }
                ASSERT_EQ(fill->notes.size(), 1U);
                EXPECT_NE(fill->notes.front().find(kind_name(truth.surface)), std::string::npos);
            }
        }
    }
}

TEST(FillRecognise, FindsEveryClosedFormFarFromTheOrigin) {
    for (const Truth& truth : truths(1.0, false)) {
        const Hole hole = moved(without_supports(windows::window_in(truth.surface, truth.window)),
                                Vector3d(1e6, -2e6, 5e5));
        const auto fill = fill_recognise(hole, {});
        ASSERT_TRUE(fill) << kind_name(truth.surface) << ": " << fill.error().message;
        const Patch& patch = fill->patches.front();
        ASSERT_EQ(kind_name(patch.surface), kind_name(truth.surface));
        const auto found = sizes(patch.surface);
        const auto real = sizes(truth.surface);
        for (std::size_t i = 0; i < real.size(); ++i) {
            // Coordinates are good to 5e-10 there.
            EXPECT_NEAR(found[i], real[i], 1e-8 * real[i]) << kind_name(truth.surface);
        }
    }
}

TEST(FillRecognise, PassesOverWhatTurnedOutToBeBad) {
    const Truth truth = truths(1.0, false)[4];
    const Hole hole = without_supports(windows::window_in(truth.surface, truth.window));
    std::vector<std::string> told;
    FillOptions options;
    options.recognised = [&](const Recognised& what) { told.push_back(what.kind); };
    ASSERT_TRUE(fill_recognise(hole, options));
    options.passed_over = 1;
    const auto fill = fill_recognise(hole, options);
    ASSERT_FALSE(fill);
    EXPECT_NE(fill.error().message.find("bad where it was tried"), std::string::npos);
    EXPECT_EQ(told, std::vector<std::string>{"torus"});
}

TEST(FillRecognise, GivesBackTheSphereOfASuitcaseCorner) {
    const auto fill = fill_recognise(zoo::suitcase_corner(3.0), {});
    ASSERT_TRUE(fill) << fill.error().message;
    const auto* sphere = std::get_if<Sphere>(&fill->patches.front().surface);
    ASSERT_NE(sphere, nullptr);
    EXPECT_NEAR(sphere->radius, 3.0, 1e-14);
    EXPECT_LT(sphere->frame.origin.norm(), 1e-14);
}

// What is wanted does not change what the normals tell.
TEST(FillRecognise, GivesBackTheSphereWherePositionAloneIsWanted) {
    const auto fill = fill_recognise(zoo::suitcase_corner(3.0, Continuity::G0), {});
    ASSERT_TRUE(fill) << fill.error().message;
    EXPECT_TRUE(std::holds_alternative<Sphere>(fill->patches.front().surface));
}

// But to the rim of a pipe a ball is tangent all around: an opening has a lid.
TEST(FillRecognise, PutsNoBallOnTheRimOfAPipe) {
    Hole rim = without_supports(
        windows::window_in(Sphere{tilted(), 2.0}, {{1.0, 0.0}, {0.0, 0.0}, 4, false}));
    const Frame frame = tilted();
    for (Ribbon& ribbon : rim.loops[0].ribbons) {
        ribbon.continuity = Continuity::G0;
        const double first = ribbon.edge - 1.0;
        ribbon.at = [frame, first](double s) {
            const double u = 0.5 * kPi * (first + s);
            const Vector3d out = std::cos(u) * frame.x + std::sin(u) * frame.y;
            RibbonPoint p;
            p.point = frame.origin + 2.0 * out;
            p.normal = out;
            p.tangent = kPi * (std::cos(u) * frame.y - std::sin(u) * frame.x);
            p.inward = frame.z;
            p.curvature.setZero();
            return p;
        };
    }
    rim.diameter = windows::diameter_of(rim);
    const auto fill = fill_recognise(rim, {});
    ASSERT_FALSE(fill);
    EXPECT_NE(fill.error().message.find("only position"), std::string::npos);
}

/// A sharp rim around the z axis, walked with or against it.
Ribbon rim(double radius, double height, double sense) {
    Ribbon ribbon;
    ribbon.continuity = Continuity::G0;
    ribbon.at = [=](double s) {
        const double phi = sense * 2.0 * kPi * s;
        RibbonPoint p;
        p.point = Vector3d(radius * std::cos(phi), radius * std::sin(phi), height);
        p.tangent = sense * 2.0 * kPi * radius * Vector3d(-std::sin(phi), std::cos(phi), 0.0);
        p.normal = (height > 0.0 ? 1.0 : -1.0) * Vector3d::UnitZ();
        p.inward = p.normal.cross(p.tangent).normalized();
        p.curvature.setZero();
        return p;
    };
    return ribbon;
}

// A bore's face looks to its axis, a post's away from it.
TEST(FillRecognise, TurnsTheCylinderBetweenTwoRimsToTheHole) {
    for (const bool bore : {false, true}) {
        const double sense = bore ? -1.0 : 1.0;
        Hole hole;
        hole.loops = {{{rim(2.0, 0.0, sense)}}, {{rim(2.0, 3.0, -sense)}}};
        hole.diameter = windows::diameter_of(hole);
        const auto fill = fill_recognise(hole, {});
        ASSERT_TRUE(fill) << fill.error().message;
        const Patch& patch = fill->patches.front();
        ASSERT_TRUE(std::holds_alternative<Cylinder>(patch.surface));
        EXPECT_EQ(patch.reversed, bore);
    }
}

void expect_refused(const Hole& hole, const std::string& what) {
    const auto fill = fill_recognise(hole, {});
    EXPECT_FALSE(fill) << what << ": " << (fill ? fill->notes.front() : "");
}

// Surfaces that are none of the kinds.
TEST(FillRecognise, TakesNoFreeformWindowForAClosedForm) {
    using zoo::circle;
    using zoo::Jet;
    using zoo::star;
    const auto paraboloid = zoo::graph(
        [](const Jet& u, const Jet& v) { return Jet(-0.5) * (u * u + Jet(0.6) * v * v); });
    const auto ellipse = [](const Jet& u, const Jet& v) {
        return zoo::Point{Jet(1.0) * cos(u), Jet(0.93) * sin(u), v};
    };
    for (const double size : {0.5, 0.3, 0.2, 0.1}) {
        expect_refused(zoo::window(zoo::saddle(1.0), circle({0.1, 0.2}, size, 4)), "saddle");
        expect_refused(zoo::window(zoo::monkey_saddle(1.0), circle({0.0, 0.0}, size, 3)),
                       "monkey saddle");
        expect_refused(zoo::window(zoo::wavy(0.2, 2.0), star({0.1, 0.1}, size, 0.2, 5, 5)), "wavy");
        expect_refused(zoo::window(zoo::wavy(0.2, 2.0), circle({0.4, 0.1}, size, 1)),
                       "wavy, round");
        expect_refused(zoo::window(paraboloid, circle({0.1, 0.2}, size, 4)), "paraboloid");
    }
    // Smaller pieces of an ellipse are arcs of circles to within what is believed.
    for (const double size : {0.5, 0.4, 0.3, 0.2}) {
        expect_refused(zoo::window(ellipse, circle({0.5, 0.2}, size, 4)), "elliptic cylinder");
    }
}

// Large spheres and tori pass nearly flat holes as well as a plane does.
TEST(FillRecognise, BelievesNothingOfNearlyFlatHoles) {
    for (const double height : {1e-2, 3e-3, 1e-3}) {
        expect_refused(zoo::window(zoo::wavy(height, 2.0), zoo::circle({0.4, 0.1}, 0.5, 4)),
                       "nearly flat");
        expect_refused(zoo::window(zoo::saddle(height), zoo::circle({0.1, 0.1}, 0.5, 3)),
                       "nearly flat saddle");
    }
}

/// The same sides walked the other way: the hole is what was the material.
Hole inside_out(Hole hole) {
    auto& ribbons = hole.loops[0].ribbons;
    std::reverse(ribbons.begin(), ribbons.end());
    for (Ribbon& ribbon : ribbons) {
        ribbon.at = [at = ribbon.at](double s) {
            RibbonPoint p = at(1.0 - s);
            p.tangent = -p.tangent;
            p.inward = -p.inward;
            return p;
        };
    }
    return hole;
}

TEST(FillRecognise, TakesTheSideOfALoopOnWhichTheHoleIs) {
    for (const bool reversed : {false, true}) {
        for (const Truth& truth : truths(1.0, reversed)) {
            const Hole window = without_supports(windows::window_in(truth.surface, truth.window));
            const auto fill = fill_recognise(inside_out(window), {});
            // Only of a sphere what is outside of a loop is a face as well.
            EXPECT_EQ(fill.has_value(), std::holds_alternative<Sphere>(truth.surface))
                << kind_name(truth.surface);
        }
    }
}

TEST(FillRecognise, TakesNeighboursWithTheirOutsideInsideForNone) {
    for (const Truth& truth : truths(1.0, false)) {
        Hole hole = without_supports(windows::window_in(truth.surface, truth.window));
        Ribbon& ribbon = hole.loops[0].ribbons[1];
        ribbon.at = [at = ribbon.at](double s) {
            RibbonPoint p = at(s);
            p.normal = -p.normal;
            return p;
        };
        expect_refused(hole, std::string(kind_name(truth.surface)) + " with a side inside out");
    }
}

TEST(FillRecognise, TakesPointsOnACylinderWithOtherNormalsForNone) {
    for (const double angle : {2.0, 20.0, 80.0}) {
        Hole hole = without_supports(
            windows::window_in(Cylinder{tilted(), 2.0}, {{1.0, 0.1}, {0.6, 0.5}, 4, false}));
        for (Ribbon& ribbon : hole.loops[0].ribbons) {
            ribbon.at = [at = ribbon.at, angle](double s) {
                RibbonPoint p = at(s);
                const Eigen::AngleAxisd turn(radians(angle), p.tangent.normalized());
                p.normal = turn * p.normal;
                p.inward = turn * p.inward;
                return p;
            };
        }
        expect_refused(hole, "turned normals");
    }
}

}  // namespace
}  // namespace suture

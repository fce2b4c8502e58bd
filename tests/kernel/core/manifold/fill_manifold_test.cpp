#include "support/ribbon_zoo.h"
#include "suture/base/tolerance.h"
#include "suture/fill/manifold.h"

#include <Eigen/Geometry>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace suture {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

/// How the patches meet the ribbons, at parameters that have nothing to do with the fitted ones.
struct Measured {
    double gap = 0.0;  ///< relative to the diameter
    double angle_deg = 0.0;
    double curvature = 0.0;  ///< of II in the direction across, times the diameter
    int sides = 0;
};

Measured measure(const Hole& hole, const FillResult& result) {
    Measured m;
    for (const Patch& patch : result.patches) {
        for (const EdgeUse& use : patch.wires.front()) {
            if (use.loop < 0) {
                continue;
            }
            ++m.sides;
            const Ribbon& ribbon = hole.loops.front().ribbons[static_cast<std::size_t>(use.index)];
            constexpr int kPlaces = 83;
            for (int k = 0; k <= kPlaces; ++k) {
                const double s = static_cast<double>(k) / kPlaces;
                const Vector2d uv = use.at(s);
                const SurfaceJet jet = evaluate(patch.surface, uv.x(), uv.y());
                const RibbonPoint wanted = ribbon.at(s);
                m.gap = std::max(m.gap, (jet.point - wanted.point).norm() / hole.diameter);
                const Vector3d n = jet.u.cross(jet.v).normalized();
                m.angle_deg = std::max(
                    m.angle_deg,
                    degrees(std::atan2(n.cross(wanted.normal).norm(), n.dot(wanted.normal))));
                const double bend = n.dot(jet.uu) - jet.u.dot(wanted.curvature * jet.u);
                m.curvature =
                    std::max(m.curvature, std::abs(bend) / jet.u.squaredNorm() * hole.diameter);
            }
        }
    }
    return m;
}

/// Tolerances that scale with the hole: a millionth of its diameter, a hundredth of a degree.
FillOptions options_for(const Hole& hole) {
    FillOptions options;
    options.tolerance.linear = 1e-5 * hole.diameter;
    options.tolerance.angular = radians(0.01);
    return options;
}

void expect_met(const Hole& hole, int patches) {
    const auto result = fill_manifold(hole, options_for(hole));
    ASSERT_TRUE(result) << result.error().message;
    EXPECT_EQ(static_cast<int>(result->patches.size()), patches);
    const Measured m = measure(hole, *result);
    EXPECT_EQ(m.sides, static_cast<int>(hole.loops.front().ribbons.size()));
    EXPECT_LT(m.gap, 1e-5);
    EXPECT_LT(m.angle_deg, 0.01);
}

TEST(FillManifold, MeetsTheNeighboursOfASuitcaseCornerOfAnySize) {
    for (const double radius : {1e-3, 1.0, 1e3}) {
        expect_met(zoo::suitcase_corner(radius), 6);
    }
}

TEST(FillManifold, MeetsTheNeighboursOfWindowsWithCorners) {
    expect_met(zoo::window(zoo::monkey_saddle(0.3), zoo::regular({0.1, 0.2}, 0.6, 6)), 12);
    expect_met(zoo::window(zoo::wavy(0.1, 2.0), zoo::regular({0.3, -0.2}, 0.5, 5)), 10);
}

TEST(FillManifold, MakesOneSideOfRibbonsThatRunOn) {
    std::vector<zoo::Curve> curves =
        zoo::polygon({{0.0, 0.0}, {0.3, 0.0}, {0.8, 0.0}, {0.7, 0.6}, {0.1, 0.7}});
    expect_met(zoo::window(zoo::saddle(0.4), curves), 8);
}

TEST(FillManifold, ClosesALoopWithoutCornersByARing) {
    for (const int pieces : {1, 4}) {
        const Hole hole = zoo::window(zoo::saddle(0.4), zoo::circle({0.1, 0.2}, 0.5, pieces));
        const auto result = fill_manifold(hole, options_for(hole));
        ASSERT_TRUE(result) << result.error().message;
        ASSERT_EQ(result->patches.size(), 1U);
        const Measured m = measure(hole, *result);
        EXPECT_EQ(m.sides, pieces);
        EXPECT_LT(m.gap, 1e-5);
        EXPECT_LT(m.angle_deg, 0.01);
        // One tangent plane at the apex: all radial derivatives lie in it.
        const Surface& surface = result->patches.front().surface;
        const Vector3d first = evaluate(surface, 0.0, 0.3).u;
        const Vector3d normal = first.cross(evaluate(surface, 0.0, 2.1).u).normalized();
        for (int k = 0; k < 12; ++k) {
            const SurfaceJet jet = evaluate(surface, 0.0, 0.5 * k);
            EXPECT_LT(jet.v.norm(), 1e-12);
            EXPECT_LT(std::abs(normal.dot(jet.u)), 1e-10 * first.norm());
            EXPECT_GT(jet.u.norm(), 0.1 * first.norm());
        }
    }
}

TEST(FillManifold, MeetsTheCurvatureWhereItIsAskedTo) {
    const auto hole = [](Continuity continuity) {
        return zoo::window(zoo::saddle(0.6), zoo::regular({0.3, 0.1}, 0.6, 5), continuity);
    };
    const Hole g1 = hole(Continuity::G1);
    const Hole g2 = hole(Continuity::G2);
    const auto plain = fill_manifold(g1, options_for(g1));
    const auto curved = fill_manifold(g2, options_for(g2));
    ASSERT_TRUE(plain && curved);
    EXPECT_LT(measure(g2, *curved).curvature, 2e-2);
    EXPECT_LT(measure(g2, *curved).angle_deg, 0.01);
    EXPECT_LT(measure(g2, *curved).curvature, 0.5 * measure(g1, *plain).curvature);
}

std::string refusal(const Hole& hole, OptionValues own = {}) {
    FillOptions options = options_for(hole);
    options.own = std::move(own);
    const auto result = fill_manifold(hole, options);
    return result ? "" : result.error().message;
}

TEST(FillManifold, SaysWhatItCannotFill) {
    const Hole reflex = zoo::window(zoo::saddle(0.2), zoo::concave({0.0, 0.0}, 0.5));
    EXPECT_NE(refusal(reflex).find("edge 3"), std::string::npos) << refusal(reflex);
    EXPECT_NE(refusal(reflex).find("interior angle"), std::string::npos);
    Hole islands = zoo::window(zoo::saddle(0.2), zoo::regular({0.0, 0.0}, 0.5, 5));
    islands.loops.push_back(islands.loops.front());
    EXPECT_NE(refusal(islands).find("2"), std::string::npos);
    islands.loops.pop_back();
    islands.through.push_back(Vector3d::Zero());
    EXPECT_NE(refusal(islands).find("inner points"), std::string::npos);
    islands.through.clear();
    OptionValue wide;
    wide.numbers = {7.0};
    EXPECT_NE(refusal(islands, {{"aperture", wide}}).find("bound"), std::string::npos);
    OptionValue few;
    few.kind = OptionKind::Count;
    few.numbers = {2.0};
    EXPECT_NE(refusal(islands, {{"layers", few}}).find("needs 4"), std::string::npos);
}

}  // namespace
}  // namespace suture

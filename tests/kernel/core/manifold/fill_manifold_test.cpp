#include "support/ribbon_zoo.h"
#include "suture/base/tolerance.h"
#include "suture/fill/manifold.h"

#include <Eigen/Geometry>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
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

/// The largest of a function of the points of all patches, which cover no more than their domains.
double largest(const FillResult& result, const std::function<double(const Vector3d&)>& f) {
    double value = 0.0;
    for (const Patch& patch : result.patches) {
        // The corners of each outline and what lies between them.
        std::vector<Vector2d> outline;
        for (const EdgeUse& use : patch.wires.front()) {
            for (const double s : {0.0, 0.5}) {
                outline.push_back(use.at(use.backwards ? 1.0 - s : s));
            }
        }
        for (const Vector2d& a : outline) {
            for (const Vector2d& b : outline) {
                const Vector2d uv = 0.7 * a + 0.3 * b;
                value = std::max(value, f(evaluate(patch.surface, uv.x(), uv.y()).point));
            }
        }
    }
    return value;
}

TEST(FillManifold, GivesBackTheSphereBetweenEqualFillets) {
    for (const double radius : {1e-3, 1.0, 1e3}) {
        const Hole hole = zoo::suitcase_corner(radius);
        const auto result = fill_manifold(hole, options_for(hole));
        ASSERT_TRUE(result) << result.error().message;
        EXPECT_LT(largest(*result,
                          [&](const Vector3d& p) { return std::abs(p.norm() - radius) / radius; }),
                  1e-3);
    }
}

/// Half of a ring, whose middle lies outside of the hole: without a guide it bulges.
TEST(FillManifold, StaysOnACylinderInABentHole) {
    const auto arc = [](double radius, double from, double to) {
        return [=](double s) {
            const double angle = from + s * (to - from);
            return std::pair<Vector2d, Vector2d>(
                radius * Vector2d(std::cos(angle), std::sin(angle)),
                radius * (to - from) * Vector2d(-std::sin(angle), std::cos(angle)));
        };
    };
    const std::vector<zoo::Curve> sides = {
        arc(0.9, 0.0, M_PI), zoo::polygon({{-0.9, 0.0}, {-0.5, 0.0}})[0], arc(0.5, M_PI, 0.0),
        zoo::polygon({{0.5, 0.0}, {0.9, 0.0}})[0]};
    const Hole hole = zoo::window(zoo::cylinder(1.0), sides);
    FillOptions options = options_for(hole);
    options.tolerance.angular = radians(0.1);
    const auto result = fill_manifold(hole, options);
    ASSERT_TRUE(result) << result.error().message;
    EXPECT_LT(
        largest(*result, [](const Vector3d& p) { return std::abs(p.head<2>().norm() - 1.0); }),
        2e-3);
}

/// Straight lines that run on into a half circle: the curvature jumps at two joints.
std::vector<zoo::Curve> stadium_end() {
    const auto line = [](Vector2d a, Vector2d b) {
        return [a, b](double s) { return std::pair<Vector2d, Vector2d>(a + s * (b - a), b - a); };
    };
    const auto arc = [](double s) {
        const double angle = M_PI * (s - 0.5);
        const Vector2d out(std::cos(angle), std::sin(angle));
        return std::pair<Vector2d, Vector2d>(Vector2d(0.3, 0.0) + 0.25 * out,
                                             0.25 * M_PI * Vector2d(-out.y(), out.x()));
    };
    return {line({-0.2, -0.25}, {0.3, -0.25}), arc, line({0.3, 0.25}, {-0.2, 0.25}),
            line({-0.2, 0.25}, {-0.4, 0.02}), line({-0.4, 0.02}, {-0.2, -0.25})};
}

TEST(FillManifold, FollowsACurvatureThatJumpsWhereRibbonsJoin) {
    expect_met(zoo::window(zoo::saddle(0.4), stadium_end()), 6);
}

TEST(FillManifold, FollowsARingWithSharpTips) {
    const Hole hole = zoo::window(zoo::saddle(0.3), zoo::star({0.1, 0.0}, 0.5, 0.2, 5, 5));
    const auto result = fill_manifold(hole, options_for(hole));
    ASSERT_TRUE(result) << result.error().message;
    const Measured m = measure(hole, *result);
    EXPECT_LT(m.gap, 1e-5);
    EXPECT_LT(m.angle_deg, 0.02);
}

/// Ribbons that miss each other at a corner by a little, as files have them.
TEST(FillManifold, ClosesCornersThatDoNotQuiteMeet) {
    Hole hole = zoo::window(zoo::saddle(0.4), zoo::regular({0.1, 0.2}, 0.6, 5));
    const double apart = 1e-4 * hole.diameter;
    Ribbon& ribbon = hole.loops.front().ribbons[2];
    ribbon.at = [at = ribbon.at, apart](double s) {
        RibbonPoint point = at(s);
        point.point += apart * point.normal;
        return point;
    };
    FillOptions options = options_for(hole);
    options.tolerance.angular = radians(0.1);
    const auto result = fill_manifold(hole, options);
    ASSERT_TRUE(result) << result.error().message;
    const Measured m = measure(hole, *result);
    EXPECT_LT(m.gap, 1e-4);
    EXPECT_LT(m.angle_deg, 0.05);
}

/// Of a half round, far from flat and much longer than wide, where a plain net folds.
TEST(FillManifold, DoesNotFoldInAHoleThatIsLongAndNarrow) {
    const Hole hole = zoo::window(
        zoo::cylinder(1.0), zoo::polygon({{-1.5, -0.02}, {1.5, -0.08}, {1.5, 0.08}, {-1.5, 0.02}}));
    const auto result = fill_manifold(hole, options_for(hole));
    ASSERT_TRUE(result) << result.error().message;
    for (const Patch& patch : result->patches) {
        const auto& spline = std::get<SplineSurface>(patch.surface);
        if (patch.exact) {
            continue;
        }
        constexpr int kGrid = 40;
        for (int i = 0; i < kGrid; ++i) {
            for (int j = 0; j < kGrid; ++j) {
                const SurfaceJet jet = evaluate(spline, (i + 0.5) / kGrid, (j + 0.5) / kGrid);
                const Vector3d out(jet.point.x(), jet.point.y(), 0.0);
                EXPECT_GT(jet.u.cross(jet.v).normalized().dot(out.normalized()), 0.7);
            }
        }
    }
}

TEST(FillManifold, WritesTheMiddleExactlyWhereThatIsAsked) {
    const Hole hole = zoo::window(zoo::saddle(0.2), zoo::regular({0.1, 0.2}, 0.6, 5));
    FillOptions options = options_for(hole);
    options.tolerance.angular = radians(0.1);
    OptionValue order;
    order.kind = OptionKind::Count;
    order.numbers = {1.0};
    OptionValue form;
    form.kind = OptionKind::Word;
    form.word = "exact";
    options.own = {{"k", order}, {"middle", form}};
    const auto result = fill_manifold(hole, options);
    ASSERT_TRUE(result) << result.error().message;
    EXPECT_GT(result->patches.size(), 50U);
    EXPECT_TRUE(std::all_of(result->patches.begin(), result->patches.end(),
                            [](const Patch& patch) { return patch.exact; }));
    EXPECT_LT(measure(hole, *result).angle_deg, 0.1);
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
    islands.through.push_back({});
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

#include "support/ribbon_zoo.h"
#include "support/trim_of.h"
#include "suture/fill/tube.h"
#include "suture/fill/tube/fairing.h"
#include "suture/fill/tube/pole.h"
#include "suture/fill/tube/quality.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace suture {
namespace {

using Eigen::Vector3d;
using testing::HasSubstr;

double angle_between(const Vector3d& a, const Vector3d& b) {
    return std::atan2(a.cross(b).norm(), a.dot(b));
}

FillOptions options_for(const Hole& hole) {
    FillOptions options;
    options.tolerance.linear = 1e-5 * hole.diameter;
    options.tolerance.angular = radians(0.1);
    return options;
}

struct Worst {
    double gap = 0.0, angle = 0.0;
};

/// Between the ribbons and the patch along its own trimming curves.
Worst at_border(const Hole& hole, const Patch& patch) {
    Worst worst;
    const auto& ribbons = hole.loops.front().ribbons;
    for (std::size_t i = 0; i < ribbons.size(); ++i) {
        constexpr int kSamples = 97;
        for (int k = 0; k <= kSamples; ++k) {
            // Short of the ends, where the surface has a normal for each side.
            const double s = 1e-9 + (1.0 - 2e-9) * k / kSamples;
            const RibbonPoint wanted = ribbons[i].at(s);
            const Eigen::Vector2d uv = test::trim_of(patch, 0, i)(s);
            const SurfaceJet jet = evaluate(patch.surface, uv.x(), uv.y());
            worst.gap = std::max(worst.gap, (jet.point - wanted.point).norm());
            worst.angle = std::max(worst.angle, angle_between(jet.u.cross(jet.v), wanted.normal));
        }
    }
    return worst;
}

std::vector<std::pair<std::string, Hole>> holes() {
    const zoo::Surface torus = zoo::torus(3.0, 1.0);
    return {{"suitcase corner", zoo::suitcase_corner(6.0)},
            {"star in a torus", zoo::window(torus, zoo::star({0.3, 0.2}, 0.3, 0.2, 5, 5))},
            {"L in a wavy sheet", zoo::window(zoo::wavy(0.2, 1.5), zoo::concave({0.2, 0.1}, 1.0))},
            {"octagon in a saddle", zoo::window(zoo::saddle(0.7), zoo::regular({0, 0}, 1.0, 8))},
            {"end of a pipe", zoo::pipe_end(2.0, 3)},
            {"more than half of a ball", zoo::sphere_cap(2.0, -0.5, 4)},
            {"circle of one edge", zoo::window(torus, zoo::circle({0.3, 0.2}, 0.3, 1))}};
}

TEST(FillTube, MeetsItsNeighboursWithinTheTolerance) {
    for (const auto& [name, hole] : holes()) {
        const FillOptions options = options_for(hole);
        const auto fill = fill_tube(hole, options);
        ASSERT_TRUE(fill) << name << ": " << fill.error().message;
        const Worst worst = at_border(hole, fill->patches.front());
        EXPECT_LT(worst.gap, options.tolerance.linear) << name;
        EXPECT_LT(worst.angle, options.tolerance.angular) << name;
    }
}

/// The paper's ways to quadratic pieces and from these to columns, with as many as are needed.
TEST(FillTube, MeetsItsNeighboursByThePapersPiecesToo) {
    for (const Hole& hole : {zoo::suitcase_corner(6.0),
                             zoo::window(zoo::torus(3.0, 1.0), zoo::circle({0.3, 0.2}, 0.3, 3))}) {
        for (const char* border : {"interpolated", "bezier", "taylor"}) {
            for (const char* join : {"fit", "march"}) {
                FillOptions options = options_for(hole);
                options.tolerance.linear = 1e-4 * hole.diameter;
                options.tolerance.angular = radians(0.5);
                options.own["border"] = {OptionKind::Word, {}, border};
                options.own["join"] = {OptionKind::Word, {}, join};
                const auto fill = fill_tube(hole, options);
                ASSERT_TRUE(fill) << border << " " << join << ": " << fill.error().message;
                const Worst worst = at_border(hole, fill->patches.front());
                EXPECT_LT(worst.gap, options.tolerance.linear) << border << " " << join;
                EXPECT_LT(worst.angle, options.tolerance.angular) << border << " " << join;
            }
        }
    }
}

TEST(FillTube, IsCubicAcrossAndQuadraticAround) {
    const Hole hole = zoo::suitcase_corner(6.0);
    const auto fill = fill_tube(hole, options_for(hole));
    ASSERT_TRUE(fill);
    const auto& surface = std::get<SplineSurface>(fill->patches.front().surface);
    EXPECT_EQ(surface.degree_u, 3);
    EXPECT_EQ(surface.degree_v, 2);
    EXPECT_FALSE(surface.rational());
    // Simple knots across: C2. Around, simple or, at the corners, double.
    int doubles = 0;
    for (std::size_t k = 4; k + 4 < surface.knots_u.size(); ++k) {
        EXPECT_LT(surface.knots_u[k], surface.knots_u[k + 1]);
    }
    for (std::size_t k = 3; k + 4 < surface.knots_v.size(); ++k) {
        doubles += surface.knots_v[k] == surface.knots_v[k + 1] ? 1 : 0;
    }
    EXPECT_EQ(doubles, 2);  // and the third at the seam
    // The pole is one point, and the seam closes, to the last bit.
    for (int j = 0; j < surface.count_v(); ++j) {
        EXPECT_EQ(surface.poles.col(surface.index(0, j)), surface.poles.col(0));
    }
    for (int i = 0; i < surface.count_u(); ++i) {
        EXPECT_EQ(surface.poles.col(surface.index(i, 0)),
                  surface.poles.col(surface.index(i, surface.count_v() - 1)));
    }
}

TEST(FillTube, HasOneNormalAtThePole) {
    for (const auto& [name, hole] : holes()) {
        const auto fill = fill_tube(hole, options_for(hole));
        ASSERT_TRUE(fill) << name;
        const Surface& surface = fill->patches.front().surface;
        const double period = std::get<SplineSurface>(surface).knots_v.back();
        double last = INFINITY;
        for (const double u : {1e-2, 1e-3, 1e-4, 1e-5}) {
            std::vector<Vector3d> normals;
            Vector3d mean = Vector3d::Zero();
            for (int k = 0; k < 200; ++k) {
                const SurfaceJet jet = evaluate(surface, u, period * (k + 0.5) / 200);
                normals.push_back(jet.u.cross(jet.v).normalized());
                mean += normals.back();
            }
            double worst = 0.0;
            for (const Vector3d& n : normals) {
                worst = std::max(worst, angle_between(n, mean));
            }
            // In proportion to u: the curvature is bounded.
            EXPECT_LT(worst, 0.2 * last) << name << " at " << u;
            last = worst;
        }
        EXPECT_LT(last, 1e-3) << name;
    }
}

/// Position, rotation and scale of the hole make no difference.
TEST(FillTube, IsTheSameInAnyPlaceAndSize) {
    const zoo::Surface torus = zoo::torus(3.0, 1.0);
    const Eigen::Matrix3d turn =
        Eigen::AngleAxisd(1.1, Vector3d(1, -2, 2).normalized()).toRotationMatrix();
    for (const auto& curves :
         {zoo::circle({0.3, 0.2}, 0.3, 3), zoo::star({0.3, 0.2}, 0.3, 0.2, 5, 5)}) {
        const Hole plain = zoo::window(torus, curves);
        const auto first = fill_tube(plain, options_for(plain));
        ASSERT_TRUE(first);
        for (const double scale : {1e-3, 1.0, 1e3}) {
            const Vector3d shift = scale * Vector3d(3, -2, 5);
            const Hole hole = zoo::window(zoo::moved(torus, scale * turn, shift), curves);
            const auto fill = fill_tube(hole, options_for(hole));
            ASSERT_TRUE(fill) << scale;
            for (const double u : {0.0, 0.5, 1.3, 1.9}) {
                for (const double v : {0.1, 5.0, 11.0}) {
                    const Vector3d a = evaluate(first->patches.front().surface, u, v).point;
                    const Vector3d b = evaluate(fill->patches.front().surface, u, v).point;
                    EXPECT_LT((scale * (turn * a) + shift - b).norm(), 1e-6 * hole.diameter)
                        << curves.size() << " sides, " << scale << " " << u << " " << v;
                }
            }
        }
    }
}

TEST(FillTube, ClosesWindowsInSpheresNearTheSphere) {
    const Hole hole = zoo::sphere_cap(2.0, 0.4, 3);
    FillOptions options = options_for(hole);
    options.own["energy"] = {OptionKind::Word, {}, "F3"};  // of the functionals the roundest
    const auto fill = fill_tube(hole, options);
    ASSERT_TRUE(fill);
    const Surface& surface = fill->patches.front().surface;
    EXPECT_NEAR(evaluate(surface, 0.0, 0.0).point.norm(), 2.0, 1e-6);
    for (const double u : {0.3, 1.0, 1.7}) {
        for (const double v : {0.1, 3.0, 7.0}) {
            EXPECT_NEAR(evaluate(surface, u, v).point.norm(), 2.0, 0.02) << u << " " << v;
        }
    }
}

/// A plane polygon with two reflex corners, long and thin: in plane and parameters alike there is a
/// lot to fold.
TEST(FillTube, StaysInThePlaneOfAPlaneHole) {
    const Hole hole = zoo::window(zoo::wavy(0.0, 1.0), zoo::polygon({{-6, 0},
                                                                     {6, 0},
                                                                     {6, 0.6},
                                                                     {5.4, 0.6},
                                                                     {5.4, 1.0},
                                                                     {-5.4, 1.0},
                                                                     {-5.4, 0.6},
                                                                     {-6, 0.6}}));
    const auto fill = fill_tube(hole, options_for(hole));
    ASSERT_TRUE(fill) << fill.error().message;
    const Surface& surface = fill->patches.front().surface;
    for (int i = 1; i <= 40; ++i) {
        for (int j = 0; j < 400; ++j) {
            const SurfaceJet jet = evaluate(surface, i / 20.0, 4.0 * kPi * (j + 0.5) / 400);
            ASSERT_LT(std::abs(jet.point.z()), 1e-9);
            ASSERT_GT(jet.u.cross(jet.v).z(), 0.0) << i << " " << j;
        }
    }
}

/// With walls for neighbours nothing leads away from the middle of the border, which an L does not
/// see: the closing point is that of the layout.
TEST(FillTube, ClosesConcaveOutlinesBetweenWalls) {
    const std::vector<std::vector<Eigen::Vector2d>> outlines = {
        {{0, 0}, {6, 0}, {6, 1}, {1, 1}, {1, 5}, {0, 5}},
        {{0, 0}, {8, 0}, {8, 4}, {4, 1.5}, {0, 4}},
        {{0, 0}, {4, 1.5}, {8, 0}, {4, 6}}};
    for (const auto& outline : outlines) {
        SCOPED_TRACE(outline.size());
        Hole hole = zoo::window(zoo::wavy(0.0, 1.0), zoo::polygon(outline));
        for (Ribbon& ribbon : hole.loops.front().ribbons) {
            ribbon.continuity = Continuity::G0;
            ribbon.at = [at = ribbon.at](double s) {
                RibbonPoint p = at(s);
                std::swap(p.normal, p.inward);  // the neighbour is a wall
                p.normal = -p.normal;
                return p;
            };
        }
        const auto fill = fill_tube(hole, options_for(hole));
        ASSERT_TRUE(fill) << fill.error().message;
        const Surface& surface = fill->patches.front().surface;
        for (int i = 1; i <= 20; ++i) {
            for (int j = 0; j < 200; ++j) {
                const SurfaceJet jet = evaluate(surface, i / 10.0, 4.0 * kPi * (j + 0.5) / 200);
                ASSERT_LT(std::abs(jet.point.z()), 1e-9);
                ASSERT_GT(jet.u.cross(jet.v).z(), 0.0) << i << " " << j;
            }
        }
    }
}

/// Real models' edges end apart by a little, and their faces lean by a little: that is neither a
/// reason for ever shorter intervals nor for a bend.
TEST(FillTube, SpreadsWhatTheEdgesAreOffByAtCorners) {
    const double off = 1e-4;
    const double lean = radians(0.05);
    Hole hole = zoo::suitcase_corner(6.0);
    const auto exact = fill_tube(hole, options_for(hole));
    ASSERT_TRUE(exact);
    Ribbon& ribbon = hole.loops.front().ribbons[1];
    ribbon.at = [at = ribbon.at, off, lean](double s) {
        RibbonPoint point = at(s);
        const Eigen::AngleAxisd turn(lean, point.tangent.normalized());
        point.point += off * point.normal;
        point.normal = turn * point.normal;
        point.inward = turn * point.inward;
        return point;
    };
    const auto fill = fill_tube(hole, options_for(hole));
    ASSERT_TRUE(fill) << fill.error().message;
    const Worst worst = at_border(hole, fill->patches.front());
    EXPECT_LT(worst.gap, 1.5 * off);
    EXPECT_LT(worst.angle, 1.5 * lean);
    const auto columns = [](const FillResult& result) {
        return std::get<SplineSurface>(result.patches.front().surface).count_v();
    };
    EXPECT_LT(columns(*fill), 1.5 * columns(*exact));
}

/// A closed smooth edge is one tube, however many edges it is cut into.
TEST(FillTube, HasNoCornersWhereSidesGoOnSmoothly) {
    const zoo::Surface torus = zoo::torus(3.0, 1.0);
    for (const int pieces : {1, 4}) {
        const Hole hole = zoo::window(torus, zoo::circle({0.3, 0.2}, 0.3, pieces));
        const auto fill = fill_tube(hole, options_for(hole));
        ASSERT_TRUE(fill) << fill.error().message;
        const auto& knots = std::get<SplineSurface>(fill->patches.front().surface).knots_v;
        for (std::size_t k = 2; k + 3 < knots.size(); ++k) {
            EXPECT_LT(knots[k], knots[k + 1]) << pieces;
        }
        const Worst worst = at_border(hole, fill->patches.front());
        EXPECT_LT(worst.angle, radians(0.1));
    }
}

TEST(FillTube, TakesThePointAndTheNormalThatAreGiven) {
    const Hole hole = zoo::suitcase_corner(6.0);
    FillOptions options = options_for(hole);
    const Vector3d pole = Vector3d::Constant(3.6);
    const Vector3d normal = Vector3d(1.0, 1.1, 0.9).normalized();
    options.own["pole"] = {OptionKind::Position, {3.6, 3.6, 3.6}, {}};
    options.own["normal"] = {OptionKind::Direction, {1.0, 1.1, 0.9}, {}};
    const auto fill = fill_tube(hole, options);
    ASSERT_TRUE(fill) << fill.error().message;
    const Surface& surface = fill->patches.front().surface;
    EXPECT_LT((evaluate(surface, 0.0, 1.0).point - pole).norm(), 1e-12);
    const SurfaceJet jet = evaluate(surface, 1e-7, 1.0);
    EXPECT_LT(angle_between(jet.u.cross(jet.v), normal), 1e-5);
}

TEST(FillTube, BendsAtThePoleAsAskedFor) {
    const Hole hole = zoo::suitcase_corner(6.0);
    for (const double kappa : {-0.3, 0.0, 0.2}) {
        FillOptions options = options_for(hole);
        options.tolerance.angular = radians(2.0);
        options.tolerance.linear = 1e-3 * hole.diameter;
        options.own["layers"] = {OptionKind::Count, {1.0}, {}};
        options.own["curvature"] = {OptionKind::Numbers, {kappa}, {}};
        const auto fill = fill_tube(hole, options);
        ASSERT_TRUE(fill) << fill.error().message;
        const auto& surface = std::get<SplineSurface>(fill->patches.front().surface);
        const Vector3d normal = Vector3d::Ones().normalized();
        // In the middle of every interval around.
        for (std::size_t k = 2; k + 3 < surface.knots_v.size(); ++k) {
            const double v = 0.5 * (surface.knots_v[k] + surface.knots_v[k + 1]);
            if (surface.knots_v[k] < surface.knots_v[k + 1]) {
                const SurfaceJet jet = evaluate(surface, 0.0, v);
                EXPECT_NEAR(jet.uu.dot(normal) / jet.u.squaredNorm(), kappa, 1e-7) << k;
            }
        }
    }
}

TEST(FillTube, RefusesWhatATubeCannotClose) {
    const Hole corner = zoo::suitcase_corner(6.0);
    FillOptions options = options_for(corner);
    options.own["pole"] = {OptionKind::Position, {9.0, -6.0, 2.0}, {}};
    const auto outside = fill_tube(corner, options);
    ASSERT_FALSE(outside);
    EXPECT_THAT(outside.error().message, HasSubstr("not star-shaped: edge"));

    Hole island = corner;
    island.loops.push_back(corner.loops.front());
    EXPECT_FALSE(fill_tube(island, {}));
    Hole through = corner;
    through.through.push_back({Vector3d(3.0, 3.0, 3.0)});
    EXPECT_FALSE(fill_tube(through, {}));

    // A horseshoe is seen from no point inside.
    const Hole horseshoe =
        zoo::window(zoo::wavy(0.0, 1.0),
                    zoo::polygon({{0, 0}, {6, 0}, {6, 4}, {5, 4}, {5, 1}, {1, 1}, {1, 4}, {0, 4}}));
    const auto refused = fill_tube(horseshoe, options_for(horseshoe));
    ASSERT_FALSE(refused);
    EXPECT_THAT(refused.error().message, HasSubstr("not star-shaped: edge"));
}

}  // namespace
}  // namespace suture

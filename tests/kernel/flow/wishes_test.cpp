#include "suture/choose/wishes.h"

#include "support/windows.h"

#include <gtest/gtest.h>

namespace suture {
namespace {

using windows::tilted;

Hole pipe_end(int sides) {
    const Cylinder pipe{tilted(), 2.0};
    Hole hole;
    auto& loop = hole.loops.emplace_back();
    for (int side = 0; side < sides; ++side) {
        Ribbon r;
        r.edge = side + 1;
        r.face = side + 1;
        r.at = [pipe, side, sides](double s) {
            const double u = 2.0 * kPi / sides * (side + s);
            const SurfaceJet jet = evaluate(Surface(pipe), u, 5.0);
            return RibbonPoint{jet.point, jet.u * 2.0 * kPi / sides,
                               jet.u.cross(jet.v).normalized(), jet.v, Eigen::Matrix3d::Zero()};
        };
        loop.ribbons.push_back(r);
    }
    hole.diameter = windows::diameter_of(hole);
    return hole;
}

TEST(WishesFor, AsksForAFlatCapOnADuct) {
    for (const int sides : {1, 4}) {
        for (const Wish& wish : wishes_for(pipe_end(sides), {})) {
            EXPECT_EQ(wish.continuity, Continuity::G0);
            EXPECT_NE(wish.reason.find("90 deg"), std::string::npos) << wish.reason;
        }
    }
}

TEST(WishesFor, HopesForCurvatureInASkinIfTheMethodHasIt) {
    for (const double scale : {1e-3, 1.0, 1e3}) {
        const Frame frame = tilted(scale);
        for (const Hole& hole :
             {windows::window_in(Torus{frame, 5.0 * scale, 2.0 * scale},
                                 {{1.0, 0.1}, {0.5, 0.4}, 3, false}),
              windows::window_in(Sphere{frame, 3.0 * scale}, {{1.0, 0.1}, {0.5, 0.4}, 1, true}),
              windows::window_in(Plane{frame}, {{0, 0}, {3 * scale, 2 * scale}, 4, false})}) {
            for (const char* method : {"auto", "mvs", "occt", "plane"}) {
                FillRequest request;
                request.method = method;
                const bool able = std::string(method) == "auto" || std::string(method) == "mvs";
                for (const Wish& wish : wishes_for(hole, request)) {
                    EXPECT_EQ(wish.continuity, able ? Continuity::G2 : Continuity::G1) << method;
                    EXPECT_EQ(wish.hoped, able);
                }
            }
        }
    }
}

/// A window in a sphere, one of whose neighbours bends otherwise: the sphere on all sides but
/// number `side`, which has this much more curvature.
Hole window_with_another_neighbour(int sides, int side, double share) {
    Hole hole = windows::window_in(Sphere{tilted(), 3.0}, {{1.0, 0.1}, {0.5, 0.4}, sides, false});
    Ribbon& ribbon = hole.loops.front().ribbons[static_cast<std::size_t>(side)];
    ribbon.at = [at = ribbon.at, share](double s) {
        RibbonPoint p = at(s);
        p.curvature *= 1.0 + share;
        return p;
    };
    return hole;
}

TEST(WishesFor, AsksForTangencyOnlyWhereCurvaturesDisagreeAtACorner) {
    const auto wishes = wishes_for(window_with_another_neighbour(5, 2, 0.05), {});
    ASSERT_EQ(wishes.size(), 5U);
    for (const std::size_t i : {0U, 4U}) {
        EXPECT_EQ(wishes[i].continuity, Continuity::G2) << wishes[i].reason;
    }
    for (const std::size_t i : {1U, 2U, 3U}) {
        EXPECT_EQ(wishes[i].continuity, Continuity::G1);
        EXPECT_FALSE(wishes[i].hoped);
        EXPECT_NE(wishes[i].reason.find("4.76 %"), std::string::npos) << wishes[i].reason;
    }
    EXPECT_NE(wishes[3].reason.find("faces 3 and 4"), std::string::npos) << wishes[3].reason;
    for (const Wish& wish : wishes_for(window_with_another_neighbour(5, 2, 0.001), {})) {
        EXPECT_EQ(wish.continuity, Continuity::G2) << wish.reason;
    }
}

TEST(WishesFor, DoesWhatTheRequestSays) {
    FillRequest request;
    request.continuity = Continuity::G2;
    request.edge_continuity[3] = Continuity::G0;
    const auto wishes = wishes_for(pipe_end(4), request);
    ASSERT_EQ(wishes.size(), 4U);
    EXPECT_EQ(wishes[0].continuity, Continuity::G2);
    EXPECT_EQ(wishes[2].continuity, Continuity::G0);
}

TEST(WishesFor, GivesUpTangencyWhereANeighbourLeadsAway) {
    // A missing edge fillet: two skins that it continues, two end faces that stand across it.
    const double r = 2.0;
    const double length = 6.0;
    const auto straight = [](int edge, Eigen::Vector3d a, Eigen::Vector3d b, Eigen::Vector3d n) {
        Ribbon ribbon;
        ribbon.edge = ribbon.face = edge;
        ribbon.at = [=](double s) {
            const Eigen::Vector3d d = b - a;
            return RibbonPoint{a + s * d, d, n, n.cross(d).normalized(), Eigen::Matrix3d::Zero()};
        };
        return ribbon;
    };
    const auto arc = [=](int edge, double x, double from, double to, Eigen::Vector3d n) {
        Ribbon ribbon;
        ribbon.edge = ribbon.face = edge;
        ribbon.at = [=](double s) {
            const double phi = from + (to - from) * s;
            const Eigen::Vector3d p(x, r * std::cos(phi), r * std::sin(phi));
            const Eigen::Vector3d d =
                (to - from) * Eigen::Vector3d(0, -r * std::sin(phi), r * std::cos(phi));
            return RibbonPoint{p, d, n, n.cross(d).normalized(), Eigen::Matrix3d::Zero()};
        };
        return ribbon;
    };
    using Eigen::Vector3d;
    Hole hole;
    hole.loops.push_back(
        {{straight(1, {length, r, 0}, {0, r, 0}, {0, 1, 0}), arc(2, 0.0, 0.0, kPi / 2, {-1, 0, 0}),
          straight(3, {0, 0, r}, {length, 0, r}, {0, 0, 1}),
          arc(4, length, kPi / 2, 0.0, {1, 0, 0})}});
    hole.diameter = windows::diameter_of(hole);
    const auto wishes = wishes_for(hole, {});
    EXPECT_EQ(wishes[0].continuity, Continuity::G1) << wishes[0].reason;
    EXPECT_EQ(wishes[1].continuity, Continuity::G0);
    EXPECT_EQ(wishes[2].continuity, Continuity::G1) << wishes[2].reason;
    EXPECT_EQ(wishes[3].continuity, Continuity::G0);
    EXPECT_NE(wishes[1].reason.find("face 2 leads away"), std::string::npos) << wishes[1].reason;
}

}  // namespace
}  // namespace suture

#include "suture/choose/wishes.h"

#include "support/windows.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

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

/// The square end of a duct whose border steps along the walls, by `step`, at the middles of two
/// opposite walls: down on one and up again on the other.
Hole duct_with_steps(double scale, double step) {
    const Frame frame = tilted(scale);
    struct Place {
        double x, y, z;
    };
    const std::vector<Place> corners{{-2, -2, 0},  {0, -2, 0},   {0, -2, step}, {2, -2, step},
                                     {2, 2, step}, {0, 2, step}, {0, 2, 0},     {-2, 2, 0}};
    const std::vector<Eigen::Vector2d> outward{{0, -1}, {0, -1}, {0, -1}, {1, 0},
                                               {0, 1},  {0, 1},  {0, 1},  {-1, 0}};
    const auto at = [&](const Place& p) -> Eigen::Vector3d {
        return frame.origin + scale * (p.x * frame.x + p.y * frame.y) + p.z * frame.z;
    };
    Hole hole;
    auto& loop = hole.loops.emplace_back();
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Eigen::Vector3d from = at(corners[i]);
        const Eigen::Vector3d along = at(corners[(i + 1) % corners.size()]) - from;
        const Eigen::Vector3d normal = outward[i].x() * frame.x + outward[i].y() * frame.y;
        Ribbon r;
        r.edge = r.face = static_cast<int>(i) + 1;
        r.at = [from, along, normal](double s) {
            return RibbonPoint{from + s * along, along, normal, normal.cross(along.normalized()),
                               Eigen::Matrix3d::Zero()};
        };
        loop.ribbons.push_back(r);
    }
    hole.diameter = windows::diameter_of(hole);
    return hole;
}

TEST(WishesFor, AsksForAFlatCapOnADuctWhoseBorderHasSteps) {
    for (const double scale : {1.0, 1e3}) {
        const FillRequest request;
        const double tolerance = request.tolerance.linear;
        for (const Wish& wish : wishes_for(duct_with_steps(scale, 0.4 * tolerance), request)) {
            EXPECT_EQ(wish.continuity, Continuity::G0) << wish.reason;
            EXPECT_FALSE(wish.own);
        }
        // A longer side is one of the border's own, which no cap is drawn over.
        const auto wishes = wishes_for(duct_with_steps(scale, 3.0 * tolerance), request);
        EXPECT_TRUE(std::ranges::any_of(wishes, &Wish::own));
    }
}

/// Where all sides are no longer than the tolerance they are no steps: the model is small.
TEST(WishesFor, TakesTheSidesOfASmallHoleForWhatTheyAre) {
    FillRequest request;
    request.tolerance.linear = 10.0;
    EXPECT_TRUE(std::ranges::any_of(wishes_for(duct_with_steps(1.0, 0.03), request), &Wish::own));
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
                const bool able = request.method == "auto" || request.method == "mvs";
                const Continuity without =
                    request.method == "plane" ? Continuity::G0 : Continuity::G1;
                for (const Wish& wish : wishes_for(hole, request)) {
                    EXPECT_EQ(wish.continuity, able ? Continuity::G2 : without) << method;
                    EXPECT_EQ(wish.hoped, able);
                }
            }
        }
    }
}

/// A duct with a square end, one of whose neighbours is folded into the opening: the continuation
/// of that one points out of the hole, that of the others along the duct.
Hole duct_with_a_flap(double scale, bool seen_from_behind) {
    const Frame frame = tilted(scale);
    const Eigen::Vector3d z = frame.z;
    const auto corner = [&](int i) -> Eigen::Vector3d {
        const double x = (i % 4 == 1 || i % 4 == 2) ? 3.0 : 0.0;
        const double y = i % 4 >= 2 ? 2.0 : 0.0;
        return frame.origin + scale * (x * frame.x + y * frame.y);
    };
    Hole hole;
    auto& loop = hole.loops.emplace_back();
    for (int k = 0; k < 4; ++k) {
        const int side = seen_from_behind ? 3 - k : k;
        const Eigen::Vector3d a = corner(seen_from_behind ? side + 1 : side);
        const Eigen::Vector3d b = corner(seen_from_behind ? side : side + 1);
        const Eigen::Vector3d out = (corner(side + 1) - corner(side)).cross(z).normalized();
        const Eigen::Vector3d inward = side == 2 ? out : z;
        Ribbon ribbon;
        ribbon.edge = ribbon.face = side + 1;
        ribbon.at = [=](double s) {
            const Eigen::Vector3d d = b - a;
            return RibbonPoint{a + s * d, d, d.cross(inward).normalized(), inward,
                               Eigen::Matrix3d::Zero()};
        };
        loop.ribbons.push_back(ribbon);
    }
    hole.diameter = windows::diameter_of(hole);
    return hole;
}

TEST(WishesFor, AsksForPositionWhereANeighbourLiesInThePlanarOpening) {
    for (const double scale : {1e-3, 1.0, 1e3}) {
        for (const bool behind : {false, true}) {
            const auto wishes = wishes_for(duct_with_a_flap(scale, behind), {});
            ASSERT_EQ(wishes.size(), 4U);
            for (const Wish& wish : wishes) {
                EXPECT_EQ(wish.continuity, Continuity::G0) << wish.reason;
                EXPECT_NE(wish.reason.find("stand on the opening at 90 deg"), std::string::npos)
                    << wish.reason;
            }
        }
    }
}

/// The same side with the neighbour on the other side of the edge.
Ribbon folded_back(const Ribbon& ribbon) {
    Ribbon folded = ribbon;
    folded.at = [at = ribbon.at](double s) {
        RibbonPoint p = at(s);
        p.inward = -p.inward;
        p.normal = -p.normal;
        return p;
    };
    return folded;
}

/// The border of an island: the same curve, walked with the hole on its other side.
RibbonLoop island_of(const RibbonLoop& window) {
    RibbonLoop island;
    for (auto ribbon = window.ribbons.rbegin(); ribbon != window.ribbons.rend(); ++ribbon) {
        island.ribbons.push_back(*ribbon);
        island.ribbons.back().face += 10;
        island.ribbons.back().at = [at = ribbon->at](double s) {
            RibbonPoint p = at(1.0 - s);
            p.tangent = -p.tangent;
            p.inward = -p.inward;
            return p;
        };
    }
    return island;
}

TEST(WishesFor, ContinuesTheSkinBesideANeighbourInTheOpening) {
    const Plane plane{tilted()};
    Hole hole = windows::window_in(plane, {{0, 0}, {3, 2}, 4, false});
    hole.loops.push_back(
        island_of(windows::window_in(plane, {{1, 0.5}, {0.5, 0.4}, 3, false}).loops.front()));
    for (const std::size_t loop : {0U, 1U}) {
        Hole folded = hole;
        folded.loops[loop].ribbons[1] = folded_back(hole.loops[loop].ribbons[1]);
        const auto wishes = wishes_for(folded, {});
        ASSERT_EQ(wishes.size(), 7U);
        for (std::size_t i = 0; i < wishes.size(); ++i) {
            if (i == 4 * loop + 1) {
                EXPECT_EQ(wishes[i].continuity, Continuity::G0) << wishes[i].reason;
                EXPECT_NE(wishes[i].reason.find("lies in the planar opening"), std::string::npos)
                    << wishes[i].reason;
            } else if (loop == 0 || i < 4) {  // the island's other normals turn over at a corner
                EXPECT_GE(wishes[i].continuity, Continuity::G1) << wishes[i].reason;
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

TEST(OddSides, AreThoseWhoseNormalsAreNotTheOthersAtBothEnds) {
    const Hole window = windows::window_in(Plane{tilted(2.0)}, {{0, 0}, {6, 4}, 5, false});
    constexpr double kAngle = radians(0.01);
    EXPECT_EQ(odd_sides(window, kAngle), std::vector<bool>(5, false));
    const auto turned = [&](std::initializer_list<std::size_t> sides, double angle) {
        Hole hole = window;
        for (const std::size_t i : sides) {
            hole.loops[0].ribbons[i].at = [at = window.loops[0].ribbons[i].at, angle](double s) {
                RibbonPoint p = at(s);
                const Eigen::AngleAxisd turn(angle, p.tangent.normalized());
                p.normal = turn * p.normal;
                p.inward = turn * p.inward;
                return p;
            };
        }
        return hole;
    };
    for (const double angle : {radians(0.5), -radians(3.0)}) {
        const auto odd = odd_sides(turned({3}, angle), kAngle);
        EXPECT_EQ(odd, (std::vector<bool>{false, false, false, true, false}));
        // Of two beside each other neither is single.
        EXPECT_EQ(odd_sides(turned({3, 4}, angle), kAngle), std::vector<bool>(5, false));
    }
    EXPECT_EQ(odd_sides(turned({3}, radians(0.005)), kAngle), std::vector<bool>(5, false));
}

/// A pentagon in a plane, whose neighbour along side 3 is turned out of it by an angle.
Hole pentagon_with_a_tilted_side(double scale, double angle) {
    constexpr int kSides = 5;
    const Frame frame = tilted(scale);
    const auto corner = [&](int i) -> Eigen::Vector3d {
        const double turn = 2.0 * kPi * i / kSides;
        return frame.origin + 3.0 * scale * (std::cos(turn) * frame.x + std::sin(turn) * frame.y);
    };
    Hole hole;
    auto& loop = hole.loops.emplace_back();
    for (int side = 0; side < kSides; ++side) {
        const Eigen::Vector3d a = corner(side);
        const Eigen::Vector3d d = corner(side + 1) - a;
        const Eigen::AngleAxisd turn(side == 3 ? angle : 0.0, d.normalized());
        const Eigen::Vector3d normal = turn * frame.z;
        Ribbon ribbon;
        ribbon.edge = ribbon.face = side + 1;
        ribbon.at = [=](double s) {
            return RibbonPoint{a + s * d, d, normal, normal.cross(d).normalized(),
                               Eigen::Matrix3d::Zero()};
        };
        loop.ribbons.push_back(ribbon);
    }
    hole.diameter = windows::diameter_of(hole);
    return hole;
}

TEST(WishesFor, AsksForPositionWhereTheBorderItselfIsSharp) {
    for (const double scale : {1e-3, 1.0, 1e3}) {
        for (const double angle : {radians(12.0), -radians(40.0), radians(60.0)}) {
            const auto wishes = wishes_for(pentagon_with_a_tilted_side(scale, angle), {});
            for (std::size_t i = 0; i < wishes.size(); ++i) {
                EXPECT_EQ(wishes[i].continuity == Continuity::G0, i == 3) << wishes[i].reason;
            }
            EXPECT_NE(wishes[3].reason.find("no face within it is tangent"), std::string::npos)
                << wishes[3].reason;
            EXPECT_FALSE(wishes[3].given_up);
        }
        for (const Wish& wish : wishes_for(pentagon_with_a_tilted_side(scale, radians(8.0)), {})) {
            EXPECT_GE(wish.continuity, Continuity::G1) << wish.reason;
        }
    }
    FillRequest asked;
    asked.continuity = Continuity::G1;
    for (const Wish& wish : wishes_for(pentagon_with_a_tilted_side(1.0, radians(40.0)), asked)) {
        EXPECT_EQ(wish.continuity, Continuity::G1);
    }
}

}  // namespace
}  // namespace suture

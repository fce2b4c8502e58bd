#include "suture/fill_holes.h"

#include <gtest/gtest.h>

#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepBuilderAPI_Sewing.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRep_Builder.hxx>
#include <TopoDS_Compound.hxx>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

namespace suture {
namespace {

constexpr int kSides = 6;

/// Six plates around a hexagon of this radius, tilted about their edges of the hexagon, the first
/// edge of each face.
TopoDS_Compound plates(double radius, const std::array<double, kSides>& tilts) {
    const BRep_Builder builder;
    TopoDS_Compound compound;
    builder.MakeCompound(compound);
    for (int k = 0; k < kSides; ++k) {
        const double down = std::tan(tilts[static_cast<std::size_t>(k)]);
        const auto corner = [&](int i, double r) {
            const double angle = 2.0 * kPi * i / kSides;
            // The outer edge lies so far from the inner one as the circles' sagittas say.
            const double away = (r - radius) * std::cos(kPi / kSides);
            return gp_Pnt(r * std::cos(angle), r * std::sin(angle), -down * away);
        };
        BRepBuilderAPI_MakePolygon border(corner(k + 1, radius), corner(k, radius),
                                          corner(k, 2.0 * radius), corner(k + 1, 2.0 * radius),
                                          /*Close=*/true);
        builder.Add(compound, BRepBuilderAPI_MakeFace(border.Wire(), /*OnlyPlane=*/true).Face());
    }
    return compound;
}

std::array<double, kSides> all(double tilt) {
    std::array<double, kSides> tilts{};
    tilts.fill(tilt);
    return tilts;
}

FillRequest of_the_hexagon() {
    FillRequest request;
    request.boundaries.resize(1);
    for (int k = 0; k < kSides; ++k) {
        request.boundaries.front().push_back(4 * k + 1);
    }
    return request;
}

TEST(OddSides, GiveTangencyUpWhereTheOthersGain) {
    for (const double radius : {1e-2, 1e4}) {
        const TopoDS_Compound open = plates(radius, {0.0, 0.0, radians(1.5), 0.0, 0.0, 0.0});
        const FillRequest request = of_the_hexagon();
        const auto outcome = fill_holes(open, occ::Numbering(open), request);
        ASSERT_TRUE(outcome) << outcome.error().message;
        const HoleReport& hole = outcome->holes.front();
        ASSERT_EQ(hole.status, FillStatus::Filled) << hole.reason;
        ASSERT_EQ(hole.sides.size(), 6U);
        for (const SideReport& side : hole.sides) {
            const bool odd = side.edge == 4 * 2 + 1;
            EXPECT_EQ(side.requested == Continuity::G0, odd) << side.edge << ": " << side.reason;
            EXPECT_NEAR(degrees(side.angle), odd ? 1.5 : 0.0, 1e-3) << hole.reason;
            EXPECT_EQ(side.reason.find("at both ends") != std::string::npos, odd) << side.reason;
        }
        EXPECT_FALSE(hole.verdict.within());
    }
}

TEST(SharpBorder, IsFilledByAFaceThatIsGoodInPosition) {
    for (const double radius : {1e-2, 1e4}) {
        for (const double tilt : {20.0, -30.0}) {
            const TopoDS_Compound open = plates(radius, all(radians(tilt)));
            const auto outcome = fill_holes(open, occ::Numbering(open), of_the_hexagon());
            ASSERT_TRUE(outcome) << outcome.error().message;
            const HoleReport& hole = outcome->holes.front();
            ASSERT_EQ(hole.status, FillStatus::Filled) << hole.reason;
            EXPECT_EQ(hole.method_used, "plane");
            EXPECT_TRUE(hole.verdict.within()) << to_text(hole.verdict.findings.front());
            for (const SideReport& side : hole.sides) {
                EXPECT_EQ(side.requested, Continuity::G0);
                EXPECT_NEAR(degrees(side.angle), std::abs(tilt), 1e-6);
                EXPECT_NE(side.reason.find("the border leaves the plane"), std::string::npos)
                    << side.reason;
            }
        }
    }
}

/// A tube ten times as long as wide with a round nose, of which a quarter is missing.
TopoDS_Shape tube_with_a_nose() {
    constexpr double kRadius = 5.0;
    constexpr double kLength = 46.0;
    constexpr double kKept = 1.5 * kPi;
    const gp_Ax2 foot(gp_Pnt(0, 0, -3), gp::DZ());
    const gp_Ax2 turned(foot.Location(), gp::DZ(), gp_Dir(0, -1, 0));
    const gp_Ax2 end(gp_Pnt(0, 0, kLength), gp::DZ());
    BRepBuilderAPI_Sewing sewing(1e-6);
    sewing.Add(BRepPrimAPI_MakeCylinder(foot, kRadius, 3.0, kKept).Cylinder().LateralFace());
    sewing.Add(BRepPrimAPI_MakeCylinder(turned, kRadius, 3.0, kPi / 2.0).Cylinder().LateralFace());
    sewing.Add(
        BRepPrimAPI_MakeCylinder(gp::XOY(), kRadius, kLength, kKept).Cylinder().LateralFace());
    sewing.Add(BRepPrimAPI_MakeSphere(end, kRadius, 0.0, kPi / 2.0, kKept).Sphere().LateralFace());
    sewing.Perform();
    return sewing.SewedShape();
}

TEST(HopesGivenUp, CountNoMoreInsideTheFace) {
    const TopoDS_Shape open = tube_with_a_nose();
    const auto outcome = fill_holes(open, occ::Numbering(open), {});
    ASSERT_TRUE(outcome) << outcome.error().message;
    const HoleReport& hole = *std::ranges::max_element(
        outcome->holes, {}, [](const HoleReport& report) { return report.sides.size(); });
    ASSERT_EQ(hole.status, FillStatus::Filled) << hole.reason;
    EXPECT_EQ(hole.method_used, "mvs");
    EXPECT_TRUE(hole.verdict.within()) << to_text(hole.verdict.findings.front());
}

TEST(LastResort, TellsTheTangencyThatOcctsFillingGivesUp) {
    const TopoDS_Compound open = plates(10.0, all(radians(4.0)));
    FillRequest request = of_the_hexagon();
    request.spoilt[kSides + 1] = {"extend", "recognise", "plane", "mvs", "quad", "tube", "occt"};
    const auto outcome = fill_holes(open, occ::Numbering(open), request);
    ASSERT_TRUE(outcome) << outcome.error().message;
    const HoleReport& hole = outcome->holes.front();
    ASSERT_EQ(hole.status, FillStatus::Filled) << hole.reason;
    EXPECT_EQ(hole.method_used, "occt (position only)");
    for (const SideReport& side : hole.sides) {
        EXPECT_EQ(side.requested, Continuity::G0);
        EXPECT_NE(side.reason.find("tangency was tried"), std::string::npos) << side.reason;
    }
    ASSERT_FALSE(hole.verdict.findings.empty());
    EXPECT_EQ(hole.verdict.findings.front().kind, FindingKind::TangencyGivenUp);
    EXPECT_NEAR(degrees(hole.verdict.findings.front().value), 4.0, 0.1);
}

}  // namespace
}  // namespace suture

#include "suture/fill_holes.h"

#include <gtest/gtest.h>

#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRep_Builder.hxx>
#include <TopoDS_Compound.hxx>

#include <cmath>
#include <string>

namespace suture {
namespace {

constexpr int kSides = 6;

/// Six plates around a hexagon of this radius, one of which is tilted about its edge of the
/// hexagon, the first edge of each face.
TopoDS_Compound plates(double radius, double tilt) {
    const BRep_Builder builder;
    TopoDS_Compound compound;
    builder.MakeCompound(compound);
    for (int k = 0; k < kSides; ++k) {
        const double down = k == 2 ? std::tan(tilt) : 0.0;
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

TEST(OddSides, GiveTangencyUpWhereTheOthersGain) {
    for (const double radius : {1e-2, 1e4}) {
        const TopoDS_Compound open = plates(radius, radians(1.5));
        FillRequest request;
        for (int k = 0; k < kSides; ++k) {
            request.boundaries.resize(1);
            request.boundaries.front().push_back(4 * k + 1);
        }
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

}  // namespace
}  // namespace suture

#include "suture/base/tolerance.h"
#include "suture/flow/plan.h"
#include "suture/occ/convert.h"

#include <gtest/gtest.h>

#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepBuilderAPI_Sewing.hxx>
#include <TopoDS_Face.hxx>
#include <gp_Ax1.hxx>
#include <gp_Trsf.hxx>

#include <cmath>
#include <initializer_list>
#include <string>

namespace suture {
namespace {

constexpr int kAround = 16;
constexpr int kRows = 8;  // from pole to pole
constexpr double kRadius = 20.0;

/// A ball of flat facets between meridians and parallels, turned, without a block of two by two
/// beside the equator.
TopoDS_Shape open_faceted_ball(double scale) {
    gp_Trsf place;
    place.SetRotation(gp_Ax1(gp_Pnt(0, 0, 0), gp_Dir(1, -2, 2)), 1.1);
    gp_Trsf size;
    size.SetScale(gp_Pnt(0, 0, 0), scale);
    place.PreMultiply(size);
    const auto corner = [&](int row, int column) {
        const double v = kPi * row / kRows - kPi / 2.0;
        const double u = 2.0 * kPi * column / kAround;
        return gp_Pnt(kRadius * std::cos(v) * std::cos(u), kRadius * std::cos(v) * std::sin(u),
                      kRadius * std::sin(v))
            .Transformed(place);
    };
    BRepBuilderAPI_Sewing sewing(1e-6 * scale);
    const auto add = [&](std::initializer_list<gp_Pnt> corners) {
        BRepBuilderAPI_MakePolygon polygon;
        for (const gp_Pnt& p : corners) {
            polygon.Add(p);
        }
        polygon.Close();
        sewing.Add(BRepBuilderAPI_MakeFace(polygon.Wire(), Standard_True).Face());
    };
    for (int row = 0; row < kRows; ++row) {
        for (int k = 0; k < kAround; ++k) {
            if (row == 0) {
                add({corner(0, 0), corner(1, k + 1), corner(1, k)});
            } else if (row == kRows - 1) {
                add({corner(row, k), corner(row, k + 1), corner(kRows, 0)});
            } else if ((row != 4 && row != 5) || k > 1) {
                add({corner(row, k), corner(row, k + 1), corner(row + 1, k + 1),
                     corner(row + 1, k)});
            }
        }
    }
    sewing.Perform();
    return sewing.SewedShape();
}

// Its borders leave the facets' planes by more than 10 degrees at their ends, as sharp edges do.
TEST(Facets, AreFollowedWhereTheirBordersAreSharp) {
    for (const double scale : {1e-2, 1.0, 1e3}) {
        SCOPED_TRACE(scale);
        const TopoDS_Shape ball = open_faceted_ball(scale);
        const occ::Numbering numbering(ball);
        const auto plan = plan_fills(ball, numbering, {});
        ASSERT_TRUE(plan) << plan.error().message;
        ASSERT_EQ(plan->holes.size(), 1U);
        const HolePlan& hole = plan->holes.front();
        ASSERT_EQ(hole.wishes.size(), 8U);
        bool sharp = false;
        for (const Wish& wish : wishes_for(*hole.hole, {})) {
            sharp = sharp || wish.sharp;
        }
        EXPECT_TRUE(sharp);
        for (const Wish& wish : hole.wishes) {
            EXPECT_EQ(wish.continuity, Continuity::G0);
            EXPECT_NE(wish.reason.find("facets"), std::string::npos) << wish.reason;
        }
        EXPECT_GT(hole.guides, 0U);
        // Nearer to the ball than the middles of the facets are.
        const double sagitta = 1.0 - std::pow(std::cos(kPi / kAround), 2);
        for (const ThroughPoint& through : hole.hole->through) {
            EXPECT_NEAR(through.point.norm(), kRadius * scale, sagitta * kRadius * scale);
        }
    }
}

}  // namespace
}  // namespace suture

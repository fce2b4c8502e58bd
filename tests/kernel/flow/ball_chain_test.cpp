#include "support/grids.h"
#include "support/properties.h"
#include "suture/fill_holes.h"
#include "suture/occ/topology.h"

#include "kernel/flow/placements.h"
#include "kernel/flow/rounded_models.h"
#include <gtest/gtest.h>

#include <BRepAdaptor_Surface.hxx>
#include <BRepCheck_Analyzer.hxx>

#include <cmath>

namespace suture {
namespace {

using placements::placed;
using placements::Placement;
using rounded::middle;

constexpr double kFoot = 2.5;

/// A block with round upright edges on a plate, its foot rounded all around.
TopoDS_Shape block_on_a_plate() {
    const TopoDS_Shape block = rounded::filleted(
        BRepPrimAPI_MakeBox(gp_Pnt(0, 0, 0), 30.0, 24.0, 20.0).Shape(), 6.0,
        [](const TopoDS_Edge& edge) { return std::abs(middle(edge).Z() - 10.0) < 1e-6; });
    const TopoDS_Shape plate = BRepPrimAPI_MakeBox(gp_Pnt(-20, -20, -8), 70.0, 64.0, 8.0).Shape();
    const TopoDS_Shape body = BRepAlgoAPI_Fuse(plate, block).Shape();
    return rounded::filleted(body, kFoot, [](const TopoDS_Edge& edge) {
        const gp_Pnt p = middle(edge);
        return std::abs(p.Z()) < 1e-6 && p.X() > -1.0 && p.X() < 31.0 && p.Y() > -1.0 &&
               p.Y() < 25.0;
    });
}

bool shares_an_edge(const TopoDS_Face& a, const TopoDS_Face& b) {
    for (const TopoDS_Edge& edge : occ::edges_of(a)) {
        for (const TopoDS_Edge& other : occ::edges_of(b)) {
            if (edge.IsSame(other)) {
                return true;
            }
        }
    }
    return false;
}

/// A ring of the foot around one corner, and the pieces left and right of it.
std::set<int> foot_of_one_corner(const TopoDS_Shape& body) {
    const std::vector<TopoDS_Face> faces = occ::faces_of(body);
    std::set<int> result;
    for (int i = 0; i < static_cast<int>(faces.size()) && result.empty(); ++i) {
        if (BRepAdaptor_Surface(faces[static_cast<std::size_t>(i)]).GetType() == GeomAbs_Torus) {
            result.insert(i);
        }
    }
    const TopoDS_Face& ring = faces[static_cast<std::size_t>(*result.begin())];
    for (int i = 0; i < static_cast<int>(faces.size()); ++i) {
        const TopoDS_Face& face = faces[static_cast<std::size_t>(i)];
        const BRepAdaptor_Surface surface(face);
        if (surface.GetType() == GeomAbs_Cylinder &&
            std::abs(surface.Cylinder().Radius() / kFoot - 1.0) < 1e-6 &&
            shares_an_edge(face, ring)) {
            result.insert(i);
        }
    }
    return result;
}

TEST(Recognise, GivesBackOneBallForTheFilletAroundACorner) {
    const TopoDS_Shape body = block_on_a_plate();
    const std::set<int> missing = foot_of_one_corner(body);
    ASSERT_EQ(missing.size(), 3U);
    const TopoDS_Shape cut = grids::without_faces(body, missing);
    for (const Placement& placement : placements::all()) {
        if (placement.name == "small" || placement.name == "large") {
            continue;  // in the tests of the method
        }
        SCOPED_TRACE(placement.name);
        const TopoDS_Shape open = placed(cut, placement);
        FillRequest request;
        request.method = "recognise";
        const auto outcome = fill_holes(open, occ::Numbering(open), request);
        ASSERT_TRUE(outcome) << outcome.error().message;
        const HoleReport& hole = outcome->holes.front();
        ASSERT_EQ(hole.status, FillStatus::Filled) << hole.reason;
        ASSERT_TRUE(hole.recognised);
        EXPECT_EQ(hole.recognised->kind, "rolling ball");
        EXPECT_NEAR(hole.recognised->parameters.front().second, kFoot, 1e-8);
        EXPECT_TRUE(BRepCheck_Analyzer(outcome->shape).IsValid());
        ASSERT_EQ(outcome->new_faces.size(), 1U);
        EXPECT_NEAR(test::area(outcome->shape), test::area(body), 1e-6 * test::area(body));
    }
}

}  // namespace
}  // namespace suture

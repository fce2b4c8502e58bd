#include "suture/base/tolerance.h"
#include "suture/detect/loop_shape.h"

#include "kernel/detect/shapes.h"

#include <BRepAdaptor_Surface.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>

namespace suture {
namespace {

double turning(const TopoDS_Shape& shape) {
    const ShellGraph graph = make_shell_graph(shape);
    const std::vector<RawLoop> loops = walk_loops(graph);
    EXPECT_EQ(loops.size(), 1U);
    return loops.empty() ? 0.0 : measure_loop(graph, loops.front()).turning;
}

/// The lateral face only: the one with more than one edge.
TopoDS_Shell side_of(const TopoDS_Shape& shape) {
    std::vector<TopoDS_Face> kept;
    for (const TopoDS_Face& face : occ::faces_of(shape)) {
        if (occ::edges_of(face).size() > 1) {
            kept.push_back(face);
        }
    }
    return test::shell_of(kept);
}

// Gauss-Bonnet: 2 pi times the Euler number less the curvature inside.
TEST(Turning, IsThatOfGaussAndBonnetOnCapsConesAndBoxes) {
    for (const double latitude : {-70.0, -10.0, 25.0, 60.0}) {
        const TopoDS_Shape cap =
            BRepPrimAPI_MakeSphere(gp_Ax2(), 3.0, radians(latitude), 0.5 * kPi).Shape();
        EXPECT_NEAR(turning(side_of(cap)), 2.0 * kPi * std::sin(radians(latitude)), 2e-2);
    }
    for (const double radius : {0.5, 2.0, 7.0}) {
        const TopoDS_Shape cone = BRepPrimAPI_MakeCone(radius, 0.0, 4.0).Shape();
        EXPECT_NEAR(turning(side_of(cone)), 2.0 * kPi * radius / std::hypot(radius, 4.0), 2e-2);
    }
    const TopoDS_Shape box = BRepPrimAPI_MakeBox(1.0, 2.0, 3.0).Shape();
    EXPECT_NEAR(turning(test::without_faces(box, {2})), 0.0, 1e-9);
    // one face of the box
    EXPECT_NEAR(turning(test::without_faces(box, {1, 3, 4, 5, 6})), 2.0 * kPi, 1e-9);
}

TEST(Turning, SumsToGaussBonnetWhereHolesTouch) {
    test::PolygonMesh mesh({{-9, -5, 0},
                            {9, -5, 0},
                            {9, 5, 0},
                            {-9, 5, 0},
                            {0, 0, 0},
                            {3, -1, 0},
                            {3, 1, 0},
                            {-3, 1, 0},
                            {-3, -1, 0}});
    const ShellGraph graph = make_shell_graph(mesh.face({{0, 1, 2, 3}, {4, 6, 5}, {4, 8, 7}}));
    double sum = 0.0;
    for (const RawLoop& loop : walk_loops(graph)) {
        sum += measure_loop(graph, loop).turning;
    }
    EXPECT_NEAR(sum, 2.0 * kPi * (1 - 2), 1e-9);
}

TEST(Turning, IsSharedByLoopsThatTouchInAVertexOfABody) {
    test::PolygonMesh mesh({{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}, {0, 0, 1.5}});
    const ShellGraph graph = make_shell_graph(
        test::shell_of({mesh.face({3, 2, 1, 0}), mesh.face({0, 1, 4}), mesh.face({2, 3, 4})}));
    const std::vector<RawLoop> loops = walk_loops(graph);
    ASSERT_EQ(loops.size(), 2U);
    // base and flaps are a disc, 2 pi; the touching vertex takes 2 pi away; both are alike
    for (const RawLoop& loop : loops) {
        EXPECT_NEAR(measure_loop(graph, loop).turning, 0.0, 1e-9);
    }
}

TEST(Turning, CountsTheAngleAtAPole) {
    for (const double degrees_of_longitude : {50.0, 90.0, 200.0}) {
        const double width = radians(degrees_of_longitude);
        const TopoDS_Shape wedge =
            BRepPrimAPI_MakeSphere(gp_Ax2(), 3.0, 0.0, 0.5 * kPi, width).Shape();
        for (const TopoDS_Face& face : occ::faces_of(wedge)) {
            if (BRepAdaptor_Surface(face).GetType() == GeomAbs_Sphere) {
                EXPECT_NEAR(turning(test::shell_of({face})), 2.0 * kPi - width, 2e-2);
            }
        }
    }
}

TEST(Turning, CountsTheAngleAtTheTipOfACone) {
    // a sector of a flat disc, rolled up
    const TopoDS_Shape cone = BRepPrimAPI_MakeCone(2.0, 0.0, 4.0, radians(300.0)).Shape();
    for (const TopoDS_Face& face : occ::faces_of(cone)) {
        if (BRepAdaptor_Surface(face).GetType() == GeomAbs_Cone) {
            EXPECT_NEAR(turning(test::shell_of({face})), 2.0 * kPi, 2e-2);
        }
    }
}

TEST(Turning, DoesNotDependOnHowTheFileTurnsTheFaces) {
    const TopoDS_Shape bucket = BRepPrimAPI_MakeCone(2.0, 5.0, 4.0).Shape();
    TopoDS_Face floor;
    TopoDS_Face wall;
    for (const TopoDS_Face& face : occ::faces_of(bucket)) {
        const BRepAdaptor_Surface surface(face);
        if (surface.GetType() == GeomAbs_Cone) {
            wall = face;
        } else if (surface.Plane().Location().Z() < 1.0) {
            floor = face;
        }
    }
    const double expected = 2.0 * kPi * 3.0 / 5.0;
    EXPECT_NEAR(turning(test::shell_of({floor, wall})), expected, 2e-2);
    EXPECT_NEAR(turning(test::shell_of({floor, TopoDS::Face(wall.Reversed())})), expected, 2e-2);
}

}  // namespace
}  // namespace suture

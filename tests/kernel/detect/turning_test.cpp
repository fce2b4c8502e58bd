#include "suture/base/tolerance.h"
#include "suture/detect/loop_shape.h"

#include "kernel/detect/shapes.h"

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

TEST(Turning, DoesNotDependOnHowTheFileTurnsTheFaces) {
    const TopoDS_Shape box = BRepPrimAPI_MakeBox(1.0, 2.0, 3.0).Shape();
    const std::vector<TopoDS_Face> faces = occ::faces_of(box);
    const TopoDS_Face turned = TopoDS::Face(faces[3].Reversed());
    EXPECT_NEAR(turning(test::shell_of({faces[0], turned})),
                turning(test::shell_of({faces[0], faces[3]})), 1e-12);
}

}  // namespace
}  // namespace suture

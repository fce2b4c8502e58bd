#include "suture/check/validity.h"

#include "suture/occ/topology.h"

#include "kernel/check/shapes.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <BRepBuilderAPI_Transform.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <ShapeFix_ShapeTolerance.hxx>

namespace suture {
namespace {

TEST(MeasureValidity, CountsAndWeighsSoundSolids) {
    const auto box = measure_validity(BRepPrimAPI_MakeBox(1, 2, 3).Shape());
    EXPECT_TRUE(box.checked);
    EXPECT_TRUE(box.valid);
    EXPECT_TRUE(box.closed);
    EXPECT_EQ(box.solids, 1);
    EXPECT_EQ(box.shells, 1);
    EXPECT_EQ(box.faces, 6);
    EXPECT_EQ(box.free_edges, 0);
    EXPECT_NEAR(box.volume.value_or(0.0), 6.0, 1e-12);
    EXPECT_EQ(box.max_tolerance, 1e-7);
    EXPECT_TRUE(box.problems.empty());

    const auto pair = measure_validity(shapes::compound(
        {BRepPrimAPI_MakeSphere(2.0).Shape(),
         BRepPrimAPI_MakeTorus(gp_Ax2({1e4, 0, 0}, {0, 0, 1}), 5.0, 2.0).Shape()}));
    EXPECT_TRUE(pair.closed);  // seams and degenerated edges are no free edges
    EXPECT_EQ(pair.solids, 2);
    EXPECT_NEAR(pair.volume.value_or(0.0), 32.0 * kPi / 3.0 + 40.0 * kPi * kPi, 1e-7);
}

TEST(MeasureValidity, InsideOutSolidHasNegativeVolume) {
    EXPECT_NEAR(
        measure_validity(BRepPrimAPI_MakeBox(1, 2, 3).Shape().Reversed()).volume.value_or(0.0),
        -6.0, 1e-12);
}

TEST(MeasureValidity, CountsTheFreeEdgesOfAnOpenShell) {
    const auto faces = occ::faces_of(BRepPrimAPI_MakeBox(1, 2, 3).Shell());
    const auto open =
        measure_validity(shapes::compound({faces[0], faces[1], faces[2], faces[3], faces[4]}));
    EXPECT_EQ(open.free_edges, 4);
    EXPECT_FALSE(open.closed);
    EXPECT_TRUE(open.valid);
    EXPECT_EQ(open.shells, 0);
    EXPECT_EQ(open.volume, 0.0);
}

TEST(MeasureValidity, NamesTheEdgeAndTheFaceOfAProblem) {
    auto box = BRepPrimAPI_MakeBox(1, 2, 3).Shape();
    const occ::Numbering numbering(box);
    // Edge5 forgets its 3D curve's agreement with the faces: moved by 0.1 on its own.
    const auto edge = TopoDS::Edge(numbering.edges(5));
    gp_Trsf shift;
    shift.SetTranslation({0.1, 0.1, 0.1});
    double first = 0.0;
    double last = 0.0;
    const auto curve =
        occ::cast<Geom_Curve>(BRep_Tool::Curve(edge, first, last)->Transformed(shift));
    BRep_Builder().UpdateEdge(edge, curve, 1e-7);
    const auto broken = measure_validity(box);
    EXPECT_TRUE(broken.checked);
    EXPECT_FALSE(broken.valid);
    EXPECT_THAT(broken.problems, testing::Contains(testing::ContainsRegex("Edge5.*: .*off the")));
}

TEST(MeasureValidity, LooksAtTopologyOnlyWhenAsked) {
    const auto box =
        measure_validity(BRepPrimAPI_MakeBox(1, 2, 3).Shape(), ValidityDepth::Topology);
    EXPECT_FALSE(box.checked);
    EXPECT_FALSE(box.valid);
    EXPECT_TRUE(box.closed);
    EXPECT_EQ(box.faces, 6);
    EXPECT_FALSE(box.volume);
}

TEST(MeasureValidity, LeavesOutTheVolumeWhenAsked) {
    const auto box = measure_validity(BRepPrimAPI_MakeBox(1, 2, 3).Shape(), ValidityDepth::Valid);
    EXPECT_TRUE(box.checked);
    EXPECT_TRUE(box.valid);
    EXPECT_FALSE(box.volume);
}

TEST(MeasureValidity, ReportsTheLargestTolerance) {
    auto box = BRepPrimAPI_MakeBox(1, 2, 3).Shape();
    const ShapeFix_ShapeTolerance tolerance;
    tolerance.SetTolerance(occ::edges_of(box).at(3), 0.01, TopAbs_EDGE);
    EXPECT_EQ(measure_validity(box).max_tolerance, 0.01);
}

TEST(MeasureValidity, SaysThatThereIsNoShape) {
    const auto nothing = measure_validity({});
    EXPECT_FALSE(nothing.valid);
    EXPECT_FALSE(nothing.closed);
    EXPECT_EQ(nothing.problems.size(), 1U);
}

}  // namespace
}  // namespace suture

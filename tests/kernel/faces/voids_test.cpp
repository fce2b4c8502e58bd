#include "suture/faces/voids.h"

#include "suture/occ/topology.h"

#include <gtest/gtest.h>

#include <BRepCheck_Analyzer.hxx>
#include <BRepGProp.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRep_Builder.hxx>
#include <GProp_GProps.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS_Solid.hxx>

namespace suture {
namespace {

double volume(const TopoDS_Shape& shape) {
    GProp_GProps properties;
    BRepGProp::VolumeProperties(shape, properties);
    return properties.Mass();
}

/// The shell of a cube that faces outwards, or inwards.
TopoDS_Shape cube_shell(double from, double size, bool inwards) {
    const TopoDS_Shape box =
        BRepPrimAPI_MakeBox(gp_Pnt(from, from, from), size, size, size).Shape();
    const TopoDS_Shape shell = TopExp_Explorer(box, TopAbs_SHELL).Current();
    return inwards ? shell.Reversed() : shell;
}

TopoDS_Shape solid_of(const TopoDS_Shape& shell) {
    const BRep_Builder builder;
    TopoDS_Solid solid;
    builder.MakeSolid(solid);
    builder.Add(solid, shell);
    return solid;
}

TEST(Voids, AreTakenInByTheSolidAroundThem) {
    const TopoDS_Shape far = solid_of(cube_shell(50.0, 20.0, false));
    const TopoDS_Shape outer = solid_of(cube_shell(0.0, 20.0, false));
    const TopoDS_Shape hollow = cube_shell(7.0, 6.0, true);
    for (const auto& shapes : {std::vector{far, outer, hollow}, std::vector{hollow, far, outer}}) {
        const auto taken = take_in_voids(shapes);
        ASSERT_EQ(taken.size(), 2U);
        EXPECT_TRUE(taken.front().IsSame(far));
        EXPECT_NEAR(volume(taken.back()), 8000.0 - 216.0, 1e-6);
        EXPECT_TRUE(BRepCheck_Analyzer(taken.back()).IsValid());
    }
}

TEST(Voids, AreTakenInWhereTheSolidIsMovedAndTurned) {
    gp_Trsf turn;
    turn.SetRotation(gp_Ax1(gp_Pnt(1, 2, 3), gp_Dir(1, 1, 2)), 0.8);
    const TopoDS_Shape outer = solid_of(cube_shell(0.0, 20.0, false)).Moved(TopLoc_Location(turn));
    const TopoDS_Shape hollow = cube_shell(7.0, 6.0, true).Moved(TopLoc_Location(turn));
    const auto taken = take_in_voids({outer, hollow});
    ASSERT_EQ(taken.size(), 1U);
    EXPECT_NEAR(volume(taken.front()), 8000.0 - 216.0, 1e-6);
    EXPECT_TRUE(BRepCheck_Analyzer(taken.front()).IsValid());
}

TEST(Voids, AreNoShellsThatFaceOutwards) {
    const auto shapes =
        std::vector{solid_of(cube_shell(0.0, 20.0, false)), cube_shell(7.0, 6.0, false)};
    EXPECT_EQ(take_in_voids(shapes).size(), 2U);
}

TEST(Voids, AreNoShellsOutsideOfTheSolidOrAcrossItsBorder) {
    for (const double from : {17.0, 30.0}) {
        const auto shapes =
            std::vector{solid_of(cube_shell(0.0, 20.0, false)), cube_shell(from, 6.0, true)};
        EXPECT_EQ(take_in_voids(shapes).size(), 2U) << from;
    }
}

}  // namespace
}  // namespace suture

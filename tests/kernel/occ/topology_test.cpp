#include "suture/occ/topology.h"

#include <gtest/gtest.h>

#include <BRepPrimAPI_MakeBox.hxx>
#include <BRep_Builder.hxx>
#include <TopoDS_Compound.hxx>
#include <gp_Trsf.hxx>

#include <cmath>

namespace suture::occ {
namespace {

TopLoc_Location moved(double x) {
    gp_Trsf trsf;
    trsf.SetTranslation(gp_Vec(x, 0, 0));
    return {trsf};
}

TEST(Topology, CountsEachFaceAndEdgeOnce) {
    const TopoDS_Shape box = BRepPrimAPI_MakeBox(1.0, 2.0, 3.0).Shape();
    EXPECT_EQ(faces_of(box).size(), 6U);
    EXPECT_EQ(edges_of(box).size(), 12U);
    EXPECT_NEAR(diagonal(box), std::sqrt(14.0), 1e-6);
    EXPECT_EQ(diagonal(TopoDS_Compound()), 0.0);
}

TEST(Numbering, NumbersFromOneInMapOrder) {
    const TopoDS_Shape box = BRepPrimAPI_MakeBox(1.0, 2.0, 3.0).Shape();
    const Numbering numbering(box);
    const auto faces = faces_of(box);
    for (std::size_t i = 0; i < faces.size(); ++i) {
        EXPECT_EQ(numbering.of(faces[i]), static_cast<int>(i) + 1);
    }
}

TEST(Numbering, GivesAPartTheNumbersOfItsFirstInstance) {
    const TopoDS_Shape other = BRepPrimAPI_MakeBox(5.0, 5.0, 5.0).Shape();
    const TopoDS_Shape part = BRepPrimAPI_MakeBox(1.0, 2.0, 3.0).Shape();
    TopoDS_Compound whole;
    BRep_Builder builder;
    builder.MakeCompound(whole);
    builder.Add(whole, other);
    builder.Add(whole, part.Moved(moved(10)));
    builder.Add(whole, part.Moved(moved(20)));
    const auto placement = placement_of(part, whole);
    ASSERT_TRUE(placement);
    EXPECT_EQ(placement->Transformation().TranslationPart().X(), 10.0);
    const Numbering numbering = numbering_of_part(Numbering(whole), part, *placement);
    EXPECT_EQ(numbering.of(faces_of(part).front()), 7);
    EXPECT_EQ(numbering.of(edges_of(part).back()), 24);
    EXPECT_FALSE(placement_of(BRepPrimAPI_MakeBox(1.0, 1.0, 1.0).Shape(), whole));
}

}  // namespace
}  // namespace suture::occ

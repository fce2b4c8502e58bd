#include "suture/sew/walls.h"

#include "support/properties.h"
#include "suture/sew/sew_shape.h"

#include "kernel/detect/shapes.h"

#include <BRepCheck_Analyzer.hxx>

namespace suture {
namespace {

using test::Census;
using test::census;

/// Two cells of a box side by side. The wall between them belongs to the first one alone; the
/// second one has its other five faces but `missing`.
TopoDS_Compound cells(std::size_t missing) {
    test::PolygonMesh mesh({{0, 0, 0},
                            {40, 0, 0},
                            {40, 50, 0},
                            {0, 50, 0},
                            {0, 0, 40},
                            {40, 0, 40},
                            {40, 50, 40},
                            {0, 50, 40},
                            {80, 0, 0},
                            {80, 50, 0},
                            {80, 0, 40},
                            {80, 50, 40}});
    const std::vector<std::vector<int>> one{{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4},
                                            {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}};
    const std::vector<std::vector<int>> two{
        {1, 2, 9, 8}, {5, 10, 11, 6}, {1, 8, 10, 5}, {8, 9, 11, 10}, {9, 2, 6, 11}};
    std::vector<TopoDS_Face> first;
    std::vector<TopoDS_Face> second;
    for (const auto& ring : one) {
        first.push_back(mesh.face(ring));
    }
    for (std::size_t i = 0; i < two.size(); ++i) {
        if (i != missing) {
            second.push_back(mesh.face(two[i]));
        }
    }
    return test::compound_of({test::shell_of(first), test::shell_of(second)});
}

TEST(Walls, BoundTheBodyOnTheirOtherSideToo) {
    for (std::size_t missing = 0; missing < 5; ++missing) {
        const auto sewn = sew_shape(test::moved(cells(missing), 1.0), 0.0);
        ASSERT_TRUE(sewn.has_value()) << sewn.error().message;
        EXPECT_EQ(sewn->walls, 1);
        EXPECT_EQ(occ::faces_of(sewn->shape).size(), 11U);
        EXPECT_EQ(census(sewn->shape), (Census{{"hole", 4}})) << missing;
    }
}

TEST(Walls, CloseABodyThatLacksNothingElse) {
    const Walls walls = give_walls(cells(5));
    EXPECT_EQ(walls.count, 1);
    EXPECT_TRUE(census(walls.shape).empty());
    EXPECT_TRUE(BRepCheck_Analyzer(walls.shape).IsValid());
}

TEST(Walls, AreNoneWhereBodiesHaveAnEdgeInCommon) {
    for (std::size_t missing = 0; missing < 6; ++missing) {
        const TopoDS_Compound boxes = test::boxes_with_common_edge(true, missing);
        const Walls walls = give_walls(boxes);
        EXPECT_EQ(walls.count, 0);
        EXPECT_TRUE(walls.shape.IsSame(boxes));
    }
}

}  // namespace
}  // namespace suture

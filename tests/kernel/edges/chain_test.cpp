#include "suture/edges/chain.h"

#include "support/read_for_test.h"
#include "suture/detect/find_loops.h"
#include "suture/edges/cut.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRep_Builder.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>

#include <algorithm>
#include <filesystem>
#include <random>

namespace suture {
namespace {

using testing::HasSubstr;

/// A loop with its islands, in the order in which holes are filled.
std::vector<BoundaryLoop> whole_hole(const std::vector<BoundaryLoop>& loops,
                                     const BoundaryLoop& first) {
    std::vector<BoundaryLoop> hole = {first};
    for (const int id : first.islands_with) {
        hole.push_back(loops[static_cast<std::size_t>(id - 1)]);
    }
    std::ranges::stable_sort(hole, std::ranges::greater(), &BoundaryLoop::length);
    return hole;
}

/// What a fill is made of has to be the same: edges, faces, and all directions.
void expect_same(const std::vector<BoundaryLoop>& chained, const std::vector<BoundaryLoop>& hole) {
    ASSERT_EQ(chained.size(), hole.size());
    for (std::size_t l = 0; l < hole.size(); ++l) {
        EXPECT_EQ(chained[l].id, hole[l].id);
        ASSERT_EQ(chained[l].edges.size(), hole[l].edges.size());
        for (std::size_t i = 0; i < hole[l].edges.size(); ++i) {
            EXPECT_TRUE(chained[l].edges[i].edge.IsEqual(hole[l].edges[i].edge));
            EXPECT_TRUE(chained[l].edges[i].face.IsEqual(hole[l].edges[i].face));
        }
    }
}

TEST(ChainEdges, GivesTheHoleWhoseEdgesAreNamedInRandomOrder) {
    const std::filesystem::path folder = std::string(SUTURE_CAD_DIR) + "/reopened";
    if (!std::filesystem::exists(folder)) {
        GTEST_SKIP() << "needs " << folder;
    }
    int holes = 0;
    for (const auto& file : std::filesystem::directory_iterator(folder)) {
        if (!file.path().string().ends_with(".open.step") || file.file_size() > 1'500'000) {
            continue;
        }
        const TopoDS_Shape shape = test::read_for_test(file.path());
        const occ::Numbering numbering(shape);
        const auto loops = find_loops(shape, numbering);
        ASSERT_TRUE(loops) << file.path();
        for (const BoundaryLoop& loop : *loops) {
            if (loop.kind != LoopKind::Hole) {
                continue;
            }
            SCOPED_TRACE(file.path().filename().string());
            const std::vector<BoundaryLoop> hole = whole_hole(*loops, loop);
            ChosenBoundary chosen;
            for (const BoundaryLoop& part : hole) {
                for (const BoundaryEdge& side : part.edges) {
                    chosen.edges.push_back(side.edge_number);
                }
            }
            std::mt19937 random(static_cast<unsigned>(++holes));
            std::ranges::shuffle(chosen.edges, random);
            const auto chained = chain_edges(shape, numbering, *loops, chosen);
            ASSERT_TRUE(chained) << chained.error().message;
            expect_same(*chained, hole);
        }
    }
    EXPECT_GT(holes, 20);
}

/// Straight curves around a square, the second one turned round, one end off by `gap`.
TopoDS_Compound square(double gap) {
    const gp_Pnt corners[] = {{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}};
    const BRep_Builder builder;
    TopoDS_Compound all;
    builder.MakeCompound(all);
    for (int i = 0; i < 4; ++i) {
        gp_Pnt a = corners[i];
        const gp_Pnt b = corners[(i + 1) % 4];
        if (i == 0) {
            a.SetX(gap);
        }
        builder.Add(all, i == 1 ? BRepBuilderAPI_MakeEdge(b, a).Edge()
                                : BRepBuilderAPI_MakeEdge(a, b).Edge());
    }
    return all;
}

Result<std::vector<BoundaryLoop>> chain(const TopoDS_Shape& shape, const ChosenBoundary& chosen) {
    return chain_edges(shape, occ::Numbering(shape), {}, chosen);
}

TEST(ChainEdges, ClosesGapsWithinReachAndNamesWiderOnes) {
    EXPECT_TRUE(chain(square(0.0), {{3, 1, 4, 2}}));
    EXPECT_TRUE(chain(square(0.01), {{3, 1, 4, 2}, 0.011}));
    const auto wide = chain(square(0.01), {{3, 1, 4, 2}, 0.009});
    ASSERT_FALSE(wide);
    EXPECT_EQ(wide.error().code, ErrorCode::Usage);
    EXPECT_THAT(wide.error().message, HasSubstr("edges 1, 2, 3, 4 form no closed chain"));
    EXPECT_THAT(wide.error().message, HasSubstr("a gap of 0.01,"));
    const auto connected = chain(square(0.01), {{3, 1, 4, 2}, 0.009, true});
    ASSERT_TRUE(connected);
    ASSERT_EQ(connected->front().edges.size(), 5U);
    EXPECT_EQ(connected->front().edges.front().edge_number, 1);
    EXPECT_EQ(std::ranges::count(connected->front().edges, 0, &BoundaryEdge::edge_number), 1);
}

TEST(ChainEdges, RefusesEdgesThatBoundNoNewFace) {
    const TopoDS_Shape box = BRepPrimAPI_MakeBox(1, 2, 3).Shape();
    EXPECT_THAT(chain(box, {{1, 2}}).error().message, HasSubstr("lies between the faces"));
    EXPECT_THAT(chain(box, {{13}}).error().message, HasSubstr("there is no edge 13"));
    EXPECT_THAT(chain(square(0), {{1, 2, 1}}).error().message, HasSubstr("edge 1 is named twice"));
    EXPECT_THAT(chain(square(0), {{}}).error().message, HasSubstr("needs edges"));
}

TEST(CutFaces, LeavesAWoundForEachGroupOfFaces) {
    const TopoDS_Shape box = BRepPrimAPI_MakeBox(1, 2, 3).Solid();
    const occ::Numbering numbering(box);
    const auto face = [&](int number) { return TopoDS::Face(numbering.faces(number)); };
    const auto opposite = cut_faces(box, {face(1), face(2)});
    ASSERT_TRUE(opposite);
    EXPECT_EQ(opposite->wounds.size(), 2U);
    EXPECT_EQ(opposite->wounds[0].size(), 4U);
    const auto adjacent = cut_faces(box, {face(1), face(3)});
    ASSERT_TRUE(adjacent);
    ASSERT_EQ(adjacent->wounds.size(), 1U);
    EXPECT_EQ(adjacent->wounds[0].size(), 6U);
    EXPECT_EQ(occ::faces_of(adjacent->shape).size(), 4U);
    EXPECT_FALSE(cut_faces(box, occ::faces_of(box)));
}

}  // namespace
}  // namespace suture

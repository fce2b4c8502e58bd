#include "support/read_for_test.h"
#include "suture/sew/sew_shape.h"

#include "kernel/detect/shapes.h"

#include <BRepExtrema_DistShapeShape.hxx>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <sstream>

namespace suture {
namespace {

using test::Census;
using test::census;

/// Sewing and finding loops stay far below the 60 s that one file may take altogether.
constexpr double kSeconds = 20.0;

struct Expected {
    const char* file;
    Census loops;
};

/// Files that are not named here are closed.
const std::vector<Expected> kFiles{
    {"Reflector_Definition.step",
     {{"hole", 3},
      {"hole", 3},
      {"hole", 4},
      {"hole", 4},
      {"hole", 6},
      {"hole", 6},
      {"hole", 6},
      {"hole", 8},
      {"hole", 8},
      {"hole", 8},
      {"hole", 20},
      {"hole", 20},
      {"hole", 20}}},
    {"nacelle.stp", {{"hole", 2}, {"hole", 2}}},
    {"ubend2.stp", {{"hole", 4}, {"hole", 4}}},
    {"bearing.iges", {{"hole", 25}}},
    // mid-surfaces of closed wings and fin; left and right ones meet at y = 0
    {"777-200LR.stp", {{"rim", 4}, {"rim", 6}, {"rim", 6}}},
    {"simple_wing.stp", {{"rim", 4}}},
    {"goteborg.iges", {{"rim", 8}}},
    {"goteborg.step", {{"rim", 8}}},
    {"DTMB-5415_bulbous_bow.iges", {{"rim", 4}}},
    {"nist_ctc_04_asme1_rd.stp", {{"rim", 2}}},
    {"nist_ctc_05_asme1_rd.stp", {{"rim", 4}}},
};

TopoDS_Shape sewn_shape(const std::string& path) {
    const TopoDS_Shape shape = test::read_for_test(path);
    EXPECT_FALSE(shape.IsNull()) << path;
    const auto sewn = sew_shape(shape, 0.0);
    EXPECT_TRUE(sewn.has_value()) << path << ": " << sewn.error().message;
    EXPECT_EQ(occ::faces_of(sewn->shape).size(), occ::faces_of(shape).size()) << path;
    return sewn->shape;
}

TEST(RealFiles, HaveTheLoopsThatTheyAreKnownFor) {
    const std::filesystem::path folder(SUTURE_CAD_DIR "/files");
    if (!std::filesystem::exists(folder)) {
        GTEST_SKIP() << "the folder of real files is not there: " << folder;
    }
    int files = 0;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        const std::string name = entry.path().filename().string();
        const auto row = std::find_if(kFiles.begin(), kFiles.end(),
                                      [&](const Expected& e) { return name == e.file; });
        const TopoDS_Shape shape = test::read_for_test(entry.path().string());
        ASSERT_FALSE(shape.IsNull()) << name;
        const auto start = std::chrono::steady_clock::now();
        const auto sewn = sew_shape(shape, 0.0);
        ASSERT_TRUE(sewn.has_value()) << name << ": " << sewn.error().message;
        // Plain readers throw all parts into one shape, where bodies that only stand beside each
        // other seem to touch: only files of loose faces are sewn here.
        const auto loops = test::loops_of(sewn->loose_faces > 0 ? sewn->shape : shape);
        const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
        EXPECT_LT(seconds.count(), kSeconds * SUTURE_TEST_SLOWDOWN) << name;
        EXPECT_EQ(occ::faces_of(sewn->shape).size(), occ::faces_of(shape).size()) << name;
        EXPECT_EQ(census(loops), row == kFiles.end() ? Census{} : row->loops) << name;
        for (const BoundaryLoop& loop : loops) {
            SCOPED_TRACE(name);
            test::expect_well_walked(loop);
            EXPECT_TRUE(loop.islands_with.empty());
        }
        ++files;
    }
    EXPECT_EQ(files, 33);
}

TEST(RealFiles, CloseTheGapsOfAnc101AndOfHammer) {
    const std::string folder = SUTURE_CAD_DIR "/files/";
    if (!std::filesystem::exists(folder)) {
        GTEST_SKIP() << "the folder of real files is not there: " << folder;
    }
    const auto gap = [&](const char* name) {
        const auto sewn = sew_shape(test::read_for_test(folder + name), 0.0);
        EXPECT_TRUE(sewn.has_value());
        EXPECT_EQ(sewn->free_edges_after, 0);
        return sewn->largest_gap;
    };
    EXPECT_NEAR(gap("ANC101-ill.stp"), 0.0185, 0.001);  // of 329 mm
    EXPECT_NEAR(gap("hammer.iges"), 0.183, 0.01);       // of 41 m
}

struct Case {
    std::string name;
    std::string file;
    std::size_t sides = 0;
    gp_Pnt near;
};

std::vector<Case> read_cases() {
    std::vector<Case> cases;
    std::ifstream table(SUTURE_CAD_DIR "/reopened/cases.tsv");
    std::string line;
    std::getline(table, line);
    while (std::getline(table, line)) {
        std::istringstream columns(line);
        Case next;
        std::string skipped;
        std::string sides;
        std::string near;
        std::getline(columns, next.name, '\t');
        std::getline(columns, next.file, '\t');
        std::getline(columns, skipped, '\t');
        std::getline(columns, sides, '\t');
        std::getline(columns, near, '\t');
        next.sides = std::stoul(sides);
        std::replace(near.begin(), near.end(), ',', ' ');
        double x = 0.0;
        double y = 0.0;
        double z = 0.0;
        std::istringstream(near) >> x >> y >> z;
        next.near = gp_Pnt(x, y, z);
        cases.push_back(next);
    }
    return cases;
}

double distance(const BoundaryLoop& loop, const gp_Pnt& point) {
    const TopoDS_Vertex vertex = BRepBuilderAPI_MakeVertex(point);
    double least = std::numeric_limits<double>::max();
    for (const BoundaryEdge& edge : loop.edges) {
        least = std::min(least, BRepExtrema_DistShapeShape(edge.edge, vertex).Value());
    }
    return least;
}

TEST(ReopenedCases, HaveExactlyTheHoleThatWasMade) {
    const std::vector<Case> cases = read_cases();
    if (cases.empty()) {
        GTEST_SKIP() << "there is no " SUTURE_CAD_DIR "/reopened/cases.tsv";
    }
    EXPECT_EQ(cases.size(), 33U);
    for (const Case& next : cases) {
        SCOPED_TRACE(next.name);
        const auto loops = test::loops_of(sewn_shape(SUTURE_CAD_DIR "/reopened/" + next.file));
        ASSERT_FALSE(loops.empty());
        // the point lies on the lost face, which can bulge far out of the loop (R13)
        const auto made = std::find_if(loops.begin(), loops.end(), [&](const BoundaryLoop& loop) {
            return loop.kind == LoopKind::Hole && loop.edges.size() == next.sides &&
                   distance(loop, next.near) <= 0.5 * loop.diameter;
        });
        ASSERT_NE(made, loops.end()) << "no hole of " << next.sides << " sides lies there";
        EXPECT_TRUE(made->islands_with.empty());
        test::expect_well_walked(*made);
        Census expected{{"hole", next.sides}};
        if (next.name == "07_house_corner") {
            expected.emplace("rim", 10);  // the house has no floor
        } else if (next.name == "R13_bspl4s_nacelle") {
            expected.insert({{"hole", 2}, {"hole", 2}});  // the ducts
        }
        EXPECT_EQ(census(loops), expected);
    }
}

}  // namespace
}  // namespace suture

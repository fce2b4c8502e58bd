#include "suture/check/continuity.h"

#include <gtest/gtest.h>
#include <sys/wait.h>

#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <STEPControl_Reader.hxx>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <limits>

namespace suture {
namespace {

namespace fs = std::filesystem;

constexpr int kNoFreecad = 77;  // what the script ends with where FreeCAD's Part cannot be loaded

class AgreesWithFreecad : public testing::TestWithParam<const char*> {};

/// FreeCAD's Part module measures the same edges by its own projections and normals.
TEST_P(AgreesWithFreecad, OnGapAndAngleOfEveryEdge) {
    const fs::path file = fs::path(SUTURE_CAD_DIR) / "files" / GetParam();
    if (!fs::exists(file)) {
        GTEST_SKIP() << file << " is not there";
    }
    Message::DefaultMessenger()->ChangePrinters().Clear();
    STEPControl_Reader reader;
    ASSERT_EQ(reader.ReadFile(file.c_str()), IFSelect_RetDone);
    reader.TransferRoots();

    const fs::path folder = fs::path(testing::TempDir()) / ("suture_check_" + file.stem().string());
    fs::create_directories(folder);
    const fs::path brep = folder / "shape.brep";
    ASSERT_TRUE(BRepTools::Write(reader.OneShape(), brep.c_str()));
    TopoDS_Shape shape;
    ASSERT_TRUE(BRepTools::Read(shape, brep.c_str(), BRep_Builder()));
    const auto report = measure_continuity(shape, Profile{}, {}, Progress{});
    ASSERT_TRUE(report);
    std::ofstream table(folder / "edges.tsv");
    table.precision(std::numeric_limits<double>::max_digits10);
    for (const auto& edge : report->edges) {
        table << edge.edge << '\t' << edge.faces[0] << '\t' << edge.faces[1] << '\t' << edge.max_gap
              << '\t' << degrees(edge.max_angle) << '\n';
    }
    table.close();

    const std::string command = "/usr/bin/python3 '" SUTURE_SOURCE_DIR
                                "/tests/kernel/check/freecad_agreement.py' '" +
                                folder.string() + "'";
    const int status = std::system(command.c_str());
    ASSERT_TRUE(WIFEXITED(status));
    fs::remove_all(folder);
    if (WEXITSTATUS(status) == kNoFreecad) {
        GTEST_SKIP() << "FreeCAD's Part module cannot be loaded";
    }
    EXPECT_EQ(WEXITSTATUS(status), 0);
}
INSTANTIATE_TEST_SUITE_P(Files, AgreesWithFreecad,
                         testing::Values("0044_bb_boxblend_03_colored.stp",
                                         "lower_leg_structure_fork.STEP", "Trigger_SO101.step",
                                         "nacelle.stp", "nist_ctc_05_asme1_rd.stp"));

}  // namespace
}  // namespace suture

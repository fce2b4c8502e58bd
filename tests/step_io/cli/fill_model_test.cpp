#include "cli/fill_model.h"

#include "files/read.h"
#include "suture/detect/find_loops.h"

#include "step_io/files/describe.h"
#include "step_io/files/files.h"
#include <fcntl.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <iterator>
#include <regex>
#include <sstream>

namespace suture::cli::test {

using io::test::describe;
using io::test::Folder;

namespace {

/// A run that nobody watches.
class SilentRun {
  public:
    SilentRun() : file_(open("/dev/null", O_WRONLY)) {}
    ~SilentRun() { close(file_); }
    SilentRun(const SilentRun&) = delete;
    SilentRun& operator=(const SilentRun&) = delete;

    Run& operator*() { return run_; }

  private:
    int file_;
    Run run_{StageLine(file_), {}, ProgressStyle::None};
};

/// The tree with names, locations, colours and layers, line by line and sorted, without the sizes
/// of parts that were filled.
std::vector<std::string> tree_of(const io::ModelFile& model) {
    static const std::regex sizes(" [0-9]+ faces, [^\n]*");
    std::istringstream text(std::regex_replace(describe(model), sizes, ""));
    std::vector<std::string> lines;
    for (std::string line; std::getline(text, line);) {
        lines.push_back(line);
    }
    std::sort(lines.begin(), lines.end());
    return lines;
}

}  // namespace

/// Its 14 faces on offset surfaces, which OCCT does not read, leave 13 holes in 7 parts. Each of
/// the faces has one bound in the file, so that no two of the loops are islands of one face.
TEST(FillModel, FillsAnAssemblyWithHolesInManyPartsAndKeepsTreeNamesAndColours) {
    SUTURE_NEEDS_CAD_FILES();
    const Folder folder;
    FillSettings settings;
    settings.input = io::test::cad("Reflector_Definition.step");
    settings.output = folder / "filled.step";
    settings.request.method = "auto";
    SilentRun run;
    const auto summary = fill_model(*run, settings);
    ASSERT_TRUE(summary) << summary.error().message;
    EXPECT_EQ(summary->holes.size(), 13U);
    for (const HoleReport& hole : summary->holes) {
        EXPECT_EQ(hole.status, FillStatus::Filled) << hole.reason;
        EXPECT_TRUE(hole.verdict.within()) << hole.reason;
    }
    EXPECT_TRUE(summary->validity.valid);
    EXPECT_TRUE(summary->validity.closed);

    const auto plain = io::read_model(settings.input, {});
    ASSERT_TRUE(plain) << plain.error().message;
    io::test::write(*plain, folder / "plain.step", io::Format::Step);
    const auto filled = io::test::read(settings.output);
    const auto before = tree_of(io::test::read(folder / "plain.step"));
    const auto after = tree_of(filled);
    EXPECT_TRUE(std::includes(after.begin(), after.end(), before.begin(), before.end()));
    // What is more are the new faces, with the colours of their neighbours.
    std::vector<std::string> more;
    std::set_difference(after.begin(), after.end(), before.begin(), before.end(),
                        std::back_inserter(more));
    EXPECT_EQ(more.size(), 13U);
    for (const std::string& line : more) {
        EXPECT_NE(line.find("surface:#"), std::string::npos) << line;
    }
    EXPECT_EQ(occ::faces_of(filled.shape()).size(), occ::faces_of(plain->shape()).size() + 13);
}

TEST(FillModel, TakesNoTwoLoopsOfFacesWithOneBoundForIslands) {
    SUTURE_NEEDS_CAD_FILES();
    const auto model = io::read_model(io::test::cad("Reflector_Definition.step"), {});
    ASSERT_TRUE(model) << model.error().message;
    for (const io::Part& part : model->parts()) {
        const auto loops = find_loops(part.shape, occ::Numbering(part.shape));
        ASSERT_TRUE(loops) << loops.error().message;
        for (const BoundaryLoop& loop : *loops) {
            EXPECT_TRUE(loop.islands_with.empty()) << part.name << " loop " << loop.id;
        }
    }
}

}  // namespace suture::cli::test

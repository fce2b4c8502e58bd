#include "cli/arguments.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>

namespace suture::cli {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;

TEST(JoinNumberLists, TakesSeveralWordsAndStopsAtTheFile) {
    EXPECT_THAT(join_number_lists({"fill", "--hole", "1", "3+4", "in.step", "-o", "out.step"}),
                ElementsAre("fill", "--hole", "1,3+4", "in.step", "-o", "out.step"));
}

TEST(JoinNumberLists, LeavesOtherOptionsAlone) {
    EXPECT_THAT(join_number_lists({"--tolerance", "1", "2"}), ElementsAre("--tolerance", "1", "2"));
    EXPECT_THAT(join_number_lists({"--hole", "x"}), ElementsAre("--hole", "x"));
    EXPECT_THAT(join_number_lists({"--edges"}), ElementsAre("--edges"));
}

TEST(ParseHoles, SeparatesHolesByCommaAndIslandsByPlus) {
    const auto holes = parse_holes("1,3+4,20");
    ASSERT_TRUE(holes);
    EXPECT_THAT(*holes, ElementsAre(ElementsAre(1), ElementsAre(3, 4), ElementsAre(20)));
}

TEST(ParseHoles, RefusesEverythingButPositiveNumbers) {
    for (const char* text : {"", "0", "-1", "1,", "a", "1.5", "1++2", "99999999999", " 1"}) {
        const auto holes = parse_holes(text);
        ASSERT_FALSE(holes) << text;
        EXPECT_EQ(holes.error().code, ErrorCode::Usage);
    }
}

TEST(ParseEdges, TakesRanges) {
    const auto edges = parse_edges("12,15-17,3");
    ASSERT_TRUE(edges);
    EXPECT_THAT(*edges, ElementsAre(12, 15, 16, 17, 3));
}

TEST(ParseEdges, RefusesBackwardAndEndlessRanges) {
    EXPECT_FALSE(parse_edges("17-15"));
    EXPECT_FALSE(parse_edges("1-2000000000"));
    EXPECT_FALSE(parse_edges("5-"));
}

TEST(ParseContinuity, TakesBothCasesAndAuto) {
    EXPECT_EQ(parse_continuity("G2").value(), Continuity::G2);
    EXPECT_EQ(parse_continuity("g0").value(), Continuity::G0);
    EXPECT_EQ(parse_continuity("auto").value(), std::nullopt);
    for (const char* text : {"G3", "G", "C1", "", "G11"}) {
        EXPECT_FALSE(parse_continuity(text)) << text;
    }
}

TEST(ParseEdgeContinuity, MapsEdgesToContinuities) {
    const auto map = parse_edge_continuity("12=G2,13=g0");
    ASSERT_TRUE(map);
    EXPECT_THAT(*map, ElementsAre(std::pair(12, Continuity::G2), std::pair(13, Continuity::G0)));
    for (const char* text : {"12", "=G1", "0=G1", "12=G7"}) {
        EXPECT_FALSE(parse_edge_continuity(text)) << text;
    }
}

TEST(ParseSupports, MapsEdgesToFaces) {
    const auto map = parse_supports("3=7,Edge4=Face7");
    ASSERT_TRUE(map);
    EXPECT_THAT(*map, ElementsAre(std::pair(3, 7), std::pair(4, 7)));
    for (const char* text : {"3", "3=", "=7", "3=0", "Face3=7", "3=7,3=8"}) {
        EXPECT_FALSE(parse_supports(text)) << text;
    }
}

TEST(ParseEdgesOnFaces, TakesEdgesWithAndWithoutAFace) {
    const auto list = parse_edges_on_faces("12,15-16,9=3");
    ASSERT_TRUE(list);
    EXPECT_THAT(*list,
                ElementsAre(std::pair(12, 0), std::pair(15, 0), std::pair(16, 0), std::pair(9, 3)));
    for (const char* text : {"9=", "9=x", "5-3", "1-2=3"}) {
        EXPECT_FALSE(parse_edges_on_faces(text)) << text;
    }
}

TEST(ExpectPositive, RefusesZeroNegativeAndNoNumbersNamingTheOption) {
    EXPECT_TRUE(expect_positive("--x", 1e-300));
    for (const double value : {0.0, -1.0, double(NAN), double(INFINITY), -double(INFINITY)}) {
        const auto result = expect_positive("--x", value);
        ASSERT_FALSE(result) << value;
        EXPECT_THAT(result.error().message, HasSubstr("--x"));
    }
}

TEST(Nearest, FindsSlipsButNotOtherWords) {
    const std::vector<std::string_view> known{"auto", "extend", "plane", "occt"};
    EXPECT_EQ(nearest("extned", known), "extend");
    EXPECT_EQ(nearest("plan", known), "plane");
    EXPECT_EQ(nearest("zebra-crossing", known), std::nullopt);
    EXPECT_EQ(nearest("x", {}), std::nullopt);
}

class ExpectWritable : public testing::Test {
  protected:
    void SetUp() override {
        folder_ = fs::path(testing::TempDir()) /
                  testing::UnitTest::GetInstance()->current_test_info()->name();
        fs::create_directories(folder_);
        std::ofstream(folder_ / "in.step") << "model";
    }
    void TearDown() override { fs::remove_all(folder_); }

    fs::path folder_;
};

TEST_F(ExpectWritable, TakesNewAndOldFilesOtherThanTheInput) {
    std::ofstream(folder_ / "old.step") << "old";
    EXPECT_TRUE(expect_writable("-o", folder_ / "new.step", folder_ / "in.step", Force::NotGiven));
    EXPECT_TRUE(expect_writable("-o", folder_ / "old.step", folder_ / "in.step", Force::NotGiven));
}

TEST_F(ExpectWritable, RefusesTheInputUnderAnyNameUnlessForced) {
    fs::create_symlink(folder_ / "in.step", folder_ / "link.step");
    for (const fs::path& output :
         {folder_ / "in.step", folder_ / "." / "in.step", folder_ / "link.step"}) {
        const auto refused = expect_writable("-o", output, folder_ / "in.step", Force::NotGiven);
        ASSERT_FALSE(refused) << output;
        EXPECT_THAT(refused.error().message, HasSubstr("--force"));
        EXPECT_TRUE(expect_writable("-o", output, folder_ / "in.step", Force::Given));
        const auto never = expect_writable("-o", output, folder_ / "in.step", Force::NotOffered);
        ASSERT_FALSE(never) << output;
        EXPECT_THAT(never.error().message, Not(HasSubstr("--force")));
    }
}

TEST_F(ExpectWritable, RefusesFoldersAndFilesInNoFolder) {
    EXPECT_FALSE(expect_writable("-o", folder_, folder_ / "in.step", Force::Given));
    const auto refused =
        expect_writable("-o", folder_ / "no" / "out.step", folder_ / "in.step", Force::Given);
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().code, ErrorCode::Usage);
}

}  // namespace
}  // namespace suture::cli

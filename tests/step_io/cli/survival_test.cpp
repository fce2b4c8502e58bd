#include "cli/survival.h"

#include "suture/base/tolerance.h"

#include <gtest/gtest.h>

#include <limits>

namespace suture::cli::test {

namespace {

HoleReport filled(double gap, double angle) {
    HoleReport hole;
    hole.ids = {7};
    hole.status = FillStatus::Filled;
    hole.max_gap = gap;
    hole.max_angle = angle;
    hole.patches.resize(1);
    hole.patches.front().face = 3;
    hole.sides.resize(4);
    return hole;
}

std::vector<WritingLoss> losses(const HoleReport& memory, const HoleReport& file) {
    return lost_by_writing(std::vector{memory}, std::vector{file});
}

}  // namespace

TEST(LostByWriting, IsNothingUpToHalfAsMuchAgain) {
    const HoleReport memory = filled(1e-3, radians(0.26));
    EXPECT_TRUE(losses(memory, memory).empty());
    EXPECT_TRUE(losses(memory, filled(1.49e-3, radians(0.38))).empty());
}

TEST(LostByWriting, IsGapAndAngleBeyond) {
    const auto found = losses(filled(1e-3, radians(0.26)), filled(4.4, radians(109.0)));
    ASSERT_EQ(found.size(), 2U);
    EXPECT_EQ(found[0].kind, WritingLoss::Kind::Gap);
    EXPECT_EQ(found[0].hole, std::vector{7});
    EXPECT_EQ(found[0].memory, 1e-3);
    EXPECT_EQ(found[0].file, 4.4);
    EXPECT_EQ(found[1].kind, WritingLoss::Kind::Angle);
    EXPECT_EQ(to_string(found[1]), "the largest angle is 109 deg in the file, 0.26 deg in memory");
}

TEST(LostByWriting, IsNothingThatRoundingMakes) {
    EXPECT_TRUE(losses(filled(1e-12, 1e-12), filled(9e-7, 9e-7)).empty());
    EXPECT_EQ(losses(filled(1e-12, 1e-12), filled(2e-6, 2e-6)).size(), 2U);
}

TEST(LostByWriting, IsAFaceOrASideThatIsNotFoundAgain) {
    const HoleReport memory = filled(1e-3, 1e-3);
    HoleReport file = memory;
    file.patches.front().face = 0;
    file.sides[2].gap = file.max_gap = std::numeric_limits<double>::quiet_NaN();
    const auto found = losses(memory, file);
    ASSERT_EQ(found.size(), 3U);
    EXPECT_EQ(to_string(found[0]), "1 of 1 new faces were not found again in the file");
    EXPECT_EQ(to_string(found[1]), "1 of 4 sides were not found again in the file");
    EXPECT_EQ(found[2].kind, WritingLoss::Kind::Gap);  // no figure is no good one
}

TEST(LostByWriting, IsNothingOfAHoleThatWasRefused) {
    HoleReport memory = filled(1e-3, 1e-3);
    memory.status = FillStatus::Refused;
    EXPECT_TRUE(losses(memory, filled(1.0, 1.0)).empty());
}

TEST(WriteWithLeastLoss, StopsAtTheFirstWayWithoutLoss) {
    std::vector<double> tried;
    const auto result = write_with_least_loss({1.0, 2.0, 3.0}, [&](double accuracy) {
        tried.push_back(accuracy);
        return Result<std::vector<WritingLoss>>(accuracy < 2.0
                                                    ? losses(filled(1.0, 0.0), filled(9.0, 0.0))
                                                    : std::vector<WritingLoss>());
    });
    ASSERT_TRUE(result);
    EXPECT_TRUE(result->empty());
    EXPECT_EQ(tried, (std::vector{1.0, 2.0}));
}

TEST(WriteWithLeastLoss, GoesBackToTheBestWay) {
    std::vector<double> tried;
    const auto result = write_with_least_loss({1.0, 2.0, 3.0}, [&](double accuracy) {
        tried.push_back(accuracy);
        const double gap = accuracy == 2.0 ? 2.0 : 9.0;
        return Result<std::vector<WritingLoss>>(losses(filled(1.0, 0.0), filled(gap, 0.0)));
    });
    ASSERT_TRUE(result);
    EXPECT_EQ(result->front().file, 2.0);
    EXPECT_EQ(tried, (std::vector{1.0, 2.0, 3.0, 2.0}));
}

TEST(WriteWithLeastLoss, PrefersAnyFigureToALostFace) {
    const auto result = write_with_least_loss({1.0, 2.0}, [&](double accuracy) {
        HoleReport file = filled(accuracy == 2.0 ? 500.0 : 1.0, 0.0);
        file.patches.front().face = accuracy == 2.0 ? 3 : 0;
        return Result<std::vector<WritingLoss>>(losses(filled(1.0, 0.0), file));
    });
    ASSERT_TRUE(result);
    EXPECT_EQ(result->front().file, 500.0);
}

TEST(WriteWithLeastLoss, EndsWhereWritingFails) {
    int tried = 0;
    const auto result = write_with_least_loss(
        {1.0, 2.0}, [&](double /*accuracy*/) -> Result<std::vector<WritingLoss>> {
            ++tried;
            return fail(ErrorCode::WriteFailed, "no room");
        });
    ASSERT_FALSE(result);
    EXPECT_EQ(tried, 1);
}

}  // namespace suture::cli::test

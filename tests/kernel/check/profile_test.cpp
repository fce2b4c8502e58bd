#include "suture/check/profile.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace suture {
namespace {

TEST(FindProfile, GivesThePublishedFiguresOfEachChecker) {
    const auto catia = find_profile("catia");
    ASSERT_TRUE(catia);
    EXPECT_EQ(catia->tolerance.linear, 0.001);
    EXPECT_DOUBLE_EQ(degrees(catia->tolerance.angular), 0.01);
    EXPECT_EQ(catia->tolerance.curvature, 0.02);
    const auto vda = find_profile("vda4955");
    ASSERT_TRUE(vda);
    EXPECT_EQ(vda->tolerance.linear, 0.02);
    EXPECT_DOUBLE_EQ(degrees(vda->tolerance.angular), 0.1);
    EXPECT_EQ(vda->tolerance.curvature, 0.1);
}

TEST(FindProfile, ListsTheKnownNamesWhenItRefuses) {
    const auto refused = find_profile("katia");
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().code, ErrorCode::Usage);
    EXPECT_THAT(refused.error().message,
                testing::AllOf(testing::HasSubstr("katia"), testing::HasSubstr("catia, vda4955")));
}

TEST(Profiles, BeginWithTheDefaultAndNameTheirSources) {
    EXPECT_EQ(profiles().front().name, Profile{}.name);
    for (const auto& profile : profiles()) {
        EXPECT_FALSE(profile.source.empty());
        EXPECT_TRUE(validate(profile.tolerance));
    }
}

}  // namespace
}  // namespace suture

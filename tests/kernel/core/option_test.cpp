#include "suture/fill/option.h"

#include "suture/base/contract.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>

namespace suture {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

constexpr std::array kKnown = {
    MethodOption{"weight", OptionKind::Number, "W", "a weight", 0.0},
    MethodOption{"rows", OptionKind::Count, "N", "rows", 1.0},
    MethodOption{"bends", OptionKind::Numbers, "K,...", "curvatures"},
    MethodOption{"pole", OptionKind::Position, "X,Y,Z", "where"},
    MethodOption{"normal", OptionKind::Direction, "X,Y,Z", "which way"},
    MethodOption{"energy", OptionKind::Word, "F1|F2", "what is least"},
};

TEST(ParseOption, ReadsEveryKind) {
    OptionValues values;
    for (const char* text : {"weight=2.5e-1", "rows=3", "bends=1,-2,.5", "pole=1,-2,3",
                             "normal=0,0,-4", "energy=F2"}) {
        const auto value = parse_option("some", kKnown, text);
        ASSERT_TRUE(value) << value.error().message;
        values.insert(*value);
    }
    EXPECT_EQ(find_number(values, "weight"), 0.25);
    EXPECT_EQ(find_count(values, "rows"), 3);
    EXPECT_THAT(find_numbers(values, "bends"), ElementsAre(1.0, -2.0, 0.5));
    EXPECT_EQ(find_vector(values, "pole"), Eigen::Vector3d(1.0, -2.0, 3.0));
    EXPECT_EQ(find_vector(values, "normal"), Eigen::Vector3d(0.0, 0.0, -4.0));
    EXPECT_EQ(find_word(values, "energy"), "F2");
    EXPECT_TRUE(validate_options("some", kKnown, values));
}

TEST(ParseOption, RefusesWhatIsNoValueOfItsKind) {
    for (const char* text :
         {"weight=-1",  "weight=",   "weight=nan",   "weight=inf", "weight=1x",
          "weight=1,2", "rows=1.5",  "rows=0",       "rows=1e300", "bends=",
          "bends=1,,2", "pole=1,2",  "pole=1,2,3,4", "pole=1 2 3", "normal=0,0,0",
          "energy=",    "energy=F3", "energy=F1|F2", "weight",     "=1"}) {
        const auto value = parse_option("some", kKnown, text);
        ASSERT_FALSE(value) << text;
        EXPECT_EQ(value.error().code, ErrorCode::Usage);
    }
}

TEST(ParseOption, NamesTheMethodAndItsOptions) {
    EXPECT_THAT(parse_option("some", kKnown, "bend=1").error().message,
                HasSubstr("method 'some' has no option 'bend'; its options are weight, rows"));
    EXPECT_THAT(parse_option("plane", {}, "bend=1").error().message, HasSubstr("'plane'"));
    EXPECT_THAT(parse_option("some", kKnown, "weight=-1").error().message,
                HasSubstr("a number of at least 0 (W), not '-1'"));
}

TEST(ValidateOptions, RefusesUnknownKeysAndOtherKinds) {
    OptionValue word;
    word.kind = OptionKind::Word;
    word.word = "F1";
    EXPECT_TRUE(validate_options("some", kKnown, {{"energy", word}}));
    EXPECT_FALSE(validate_options("some", kKnown, {{"weight", word}}));
    EXPECT_FALSE(validate_options("some", kKnown, {{"other", word}}));
    EXPECT_FALSE(validate_options("auto", {}, {{"energy", word}}));
}

TEST(FindNumber, FindsNothingWhereNothingWasGiven) {
    EXPECT_FALSE(find_number({}, "weight"));
    EXPECT_FALSE(find_count({}, "rows"));
    EXPECT_FALSE(find_vector({}, "pole"));
    EXPECT_FALSE(find_word({}, "energy"));
    EXPECT_TRUE(find_numbers({}, "bends").empty());
}

TEST(FindNumber, IsNotForValuesOfAnotherKind) {
    OptionValue pair;
    pair.numbers = {1.0, 2.0};
    EXPECT_THROW((void)find_number({{"weight", pair}}, "weight"), ContractViolation);
    EXPECT_THROW((void)find_vector({{"pole", pair}}, "pole"), ContractViolation);
}

}  // namespace
}  // namespace suture

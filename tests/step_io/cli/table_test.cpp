#include "cli/table.h"

#include "suture/base/contract.h"

#include <gtest/gtest.h>

#include <limits>

namespace suture::cli {
namespace {

TEST(Table, AlignsColumnsByTheirWidestCell) {
    Table table({"name", ">size"});
    table.add({"a", "100"});
    table.add({"longer", "7"});
    EXPECT_EQ(table.text(),
              "name    size\n"
              "a        100\n"
              "longer     7\n");
}

TEST(Table, CountsLettersNotBytes) {
    Table table({"name", ">n"});
    table.add({"Gehäuse", "1"});
    table.add({"Gehause", "2"});
    EXPECT_EQ(table.text(),
              "name     n\n"
              "Gehäuse  1\n"
              "Gehause  2\n");
}

TEST(Table, RefusesRowOfWrongLength) {
    Table table({"a", "b"});
    EXPECT_THROW(table.add({"only one"}), ContractViolation);
}

TEST(Table, KeepsTheFirstRowsOnly) {
    Table table({"a"});
    table.add({"1"});
    table.add({"2"});
    table.keep_first(1);
    EXPECT_EQ(table.text(), "a\n1\n");
    table.keep_first(5);
    EXPECT_EQ(table.rows().size(), 1U);
}

TEST(ShortNumber, IsPlainWhereThatIsShort) {
    EXPECT_EQ(short_number(0.0), "0");
    EXPECT_EQ(short_number(12.5), "12.5");
    EXPECT_EQ(short_number(0.0123456), "0.01235");
    EXPECT_EQ(short_number(3.2e-7), "3.2e-07");
    EXPECT_EQ(short_number(-4.0e7), "-4.0e+07");
}

TEST(ShortNumber, ShowsADashForWhatWasNotMeasured) {
    EXPECT_EQ(short_number(std::numeric_limits<double>::quiet_NaN()), "-");
    EXPECT_EQ(short_number(std::numeric_limits<double>::infinity()), "-");
}

TEST(Ranges, JoinsThreeOrMoreInARow) {
    EXPECT_EQ(ranges({9, 1, 2, 5, 6, 7, 8}), "1, 2, 5-9");
    EXPECT_EQ(ranges({4}), "4");
    EXPECT_EQ(ranges({}), "");
}

TEST(Counted, AddsTheS) {
    EXPECT_EQ(counted(1, "hole"), "1 hole");
    EXPECT_EQ(counted(0, "hole"), "0 holes");
    EXPECT_EQ(counted(2, "near miss"), "2 near misses");
}

}  // namespace
}  // namespace suture::cli

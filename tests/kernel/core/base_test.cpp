#include "suture/base/contract.h"
#include "suture/base/text.h"
#include "suture/base/tolerance.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace suture {
namespace {

TEST(Tolerance, DefaultsAreValid) {
    EXPECT_TRUE(validate(Tolerance{}));
}

TEST(Tolerance, RefusesWhatIsNoPositiveFiniteNumberAndSaysWhich) {
    const double bad[] = {0.0, -1.0, std::numeric_limits<double>::quiet_NaN(),
                          std::numeric_limits<double>::infinity()};
    for (const double value : bad) {
        Tolerance linear;
        linear.linear = value;
        ASSERT_FALSE(validate(linear)) << value;
        EXPECT_EQ(validate(linear).error().code, ErrorCode::Usage);
        EXPECT_NE(validate(linear).error().message.find("length"), std::string::npos);
        Tolerance angular;
        angular.angular = value;
        ASSERT_FALSE(validate(angular)) << value;
        EXPECT_NE(validate(angular).error().message.find("angular"), std::string::npos);
        Tolerance curvature;
        curvature.curvature = value;
        ASSERT_FALSE(validate(curvature)) << value;
        EXPECT_NE(validate(curvature).error().message.find("curvature"), std::string::npos);
    }
}

TEST(Tolerance, RefusesAnAngleBeyondAHalfTurn) {
    Tolerance tolerance;
    tolerance.angular = 3.2;
    EXPECT_FALSE(validate(tolerance));
}

TEST(Contract, ThrowsWithTheBrokenCondition) {
    const int n = 3;
    try {
        SUTURE_EXPECTS(n == 4);
        FAIL() << "no exception";
    } catch (const ContractViolation& violation) {
        EXPECT_NE(std::string(violation.what()).find("n == 4"), std::string::npos);
    }
}

TEST(Text, SplitsAtEverySeparator) {
    EXPECT_EQ(split("a,,bc,", ','), (std::vector<std::string_view>{"a", "", "bc", ""}));
    EXPECT_EQ(split("", ','), std::vector<std::string_view>{""});
}

TEST(Text, EscapesWhatMarkupCannotHold) {
    EXPECT_EQ(escape_markup("a<b> & \"c\"\n"), "a&lt;b&gt; &amp; &quot;c&quot;\n");
    EXPECT_EQ(escape_markup(std::string_view("\x01\t\0", 3)), "?\t?");
    EXPECT_EQ(escape_markup("gr\xc3\xbcn"), "gr\xc3\xbcn");
    EXPECT_EQ(escape_markup("gr\xfcn"), "gr\xEF\xBF\xBDn");
}

TEST(Text, ReplacesEveryByteThatIsNoUtf8) {
    const std::string good = "a\xc3\xbc\xe2\x82\xac\xf0\x9f\x98\x80";
    EXPECT_EQ(valid_utf8(good), good);
    const std::string bad = "\xEF\xBF\xBD";
    EXPECT_EQ(valid_utf8("\xff"), bad);
    EXPECT_EQ(valid_utf8("\xc3"), bad);                                // cut off
    EXPECT_EQ(valid_utf8("\xc0\xaf"), bad + bad);                      // overlong
    EXPECT_EQ(valid_utf8("\xed\xa0\x80"), bad + bad + bad);            // a surrogate
    EXPECT_EQ(valid_utf8("\xf4\x90\x80\x80"), bad + bad + bad + bad);  // beyond Unicode
}

TEST(Text, MakesVisibleWhatSteersATerminal) {
    EXPECT_EQ(visible("a\x1b[31mb\x07\x7f"), "a\\x1B[31mb\\x07\\x7F");
    EXPECT_EQ(visible("\xc2\x9b"), "\\x9B");        // C1: the short form of ESC [
    EXPECT_EQ(visible("\xe2\x80\xae"), "\\u202E");  // right to left from here on
    EXPECT_EQ(visible("gr\xc3\xbcn \\"), "gr\xc3\xbcn \\");
}

TEST(Text, ShortensInTheMiddle) {
    EXPECT_EQ(shortened("abcdefghij", 10), "abcdefghij");
    EXPECT_EQ(shortened("abcdefghijk", 10), "abcde...jk");
    EXPECT_EQ(shortened("\xc3\xa4\xc3\xb6\xc3\xbc\xc3\xa4\xc3\xb6\xc3\xbc", 5),
              "\xc3\xa4\xc3\xb6...");
}

}  // namespace
}  // namespace suture

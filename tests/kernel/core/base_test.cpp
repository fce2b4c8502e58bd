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
}

}  // namespace
}  // namespace suture

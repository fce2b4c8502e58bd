#include "suture/platform/on_demand.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

namespace suture::test {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

TEST(OnDemand, FindsAFunctionOfALibrary) {
    const auto cosine = function_on_demand<double(double)>("libm.so.6", "cos");
    EXPECT_EQ(cosine(0.7), std::cos(0.7));
    EXPECT_EQ(cosine, function_on_demand<double(double)>("libm.so.6", "cos"));
}

TEST(OnDemand, NamesTheLibraryThatIsMissing) {
    EXPECT_THAT([] { static_cast<void>(symbol_on_demand("libnone.so.1", "cos")); },
                ThrowsMessage<std::runtime_error>(HasSubstr("libnone.so.1")));
}

TEST(OnDemand, NamesTheSymbolThatIsMissing) {
    EXPECT_THAT([] { static_cast<void>(symbol_on_demand("libm.so.6", "no_such_function")); },
                ThrowsMessage<std::runtime_error>(HasSubstr("no_such_function")));
}

}  // namespace suture::test

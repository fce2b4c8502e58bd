#include "suture/occ/guard.h"

#include <gtest/gtest.h>

#include <Standard_ConstructionError.hxx>
#include <TopoDS_Shape.hxx>

#include <stdexcept>

namespace suture::occ {
namespace {

TEST(Guarded, ReturnsTheValueOfAnActionThatSucceeds) {
    EXPECT_EQ(guarded("counting", [] { return 7; }).value(), 7);
    EXPECT_TRUE(guarded("doing nothing", [] {}));
}

TEST(Guarded, TurnsOcctsExceptionIntoAnErrorThatNamesIt) {
    const auto result = guarded("making a vector",
                                []() -> int { throw Standard_ConstructionError("no direction"); });
    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().code, ErrorCode::Internal);
    EXPECT_EQ(result.error().message,
              "making a vector: OCCT raised Standard_ConstructionError: no direction");
}

TEST(Guarded, TurnsStandardExceptionsIntoErrors) {
    const auto result = guarded("parsing", []() -> int { throw std::runtime_error("line 3"); });
    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().message, "parsing: line 3");
}

TEST(Guarded, RefusesANullShape) {
    const auto result = guarded("filling", [] { return TopoDS_Shape(); });
    ASSERT_FALSE(result);
    EXPECT_NE(result.error().message.find("no shape"), std::string::npos);
}

TEST(Guarded, PassesTheActionsOwnRefusalOn) {
    const auto result = guarded("filling", []() -> Result<int> {
        return fail(ErrorCode::Refused, "edge {} has no length", 4);
    });
    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().code, ErrorCode::Refused);
    EXPECT_EQ(result.error().message, "edge 4 has no length");
}

TEST(Guarded, LetsOurOwnBugsThrough) {
    EXPECT_THROW((void)guarded("filling", [] { SUTURE_EXPECTS(1 == 2); }), ContractViolation);
}

}  // namespace
}  // namespace suture::occ

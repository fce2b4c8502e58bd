#include "suture/occ/isolate.h"

#include <gtest/gtest.h>
#include <sys/wait.h>

#include <Standard_DomainError.hxx>

#include <chrono>
#include <csignal>
#include <thread>

namespace suture::occ {
namespace {

using namespace std::chrono_literals;

TEST(RunIsolated, BringsTheBytesBackAlsoManyOfThem) {
    std::string large(3'000'000, 'x');
    large[1'234'567] = '\0';
    const auto result =
        run_isolated("copying", [&] { return Result<std::string>(large); }, 60s, {});
    ASSERT_TRUE(result) << result.error().message;
    EXPECT_EQ(*result, large);
}

TEST(RunIsolated, ReportsACrashBySignalName) {
    const auto result = run_isolated("OCCT's filling",
                                     []() -> Result<std::string> {
                                         std::signal(SIGSEGV, SIG_DFL);
                                         std::raise(SIGSEGV);
                                         return std::string();
                                     },
                                     60s, {});
    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().code, ErrorCode::Internal);
    EXPECT_EQ(result.error().message, "OCCT's filling crashed (Segmentation fault)");
}

TEST(RunIsolated, EndsAHangAtTheLimit) {
    const auto start = std::chrono::steady_clock::now();
    const auto result = run_isolated("OCCT's filling",
                                     []() -> Result<std::string> {
                                         for (;;) {
                                             std::this_thread::sleep_for(1s);
                                         }
                                     },
                                     300ms, {});
    ASSERT_FALSE(result);
    EXPECT_NE(result.error().message.find("no answer within"), std::string::npos);
    EXPECT_LT(std::chrono::steady_clock::now() - start, 5s * SUTURE_TEST_SLOWDOWN);
    EXPECT_EQ(waitpid(-1, nullptr, WNOHANG), -1);  // no child is left
}

TEST(RunIsolated, StopsWhenCancelled) {
    std::stop_source source;
    Progress progress;
    progress.cancel = source.get_token();
    std::jthread stopper([&] {
        std::this_thread::sleep_for(200ms);
        source.request_stop();
    });
    const auto result = run_isolated(
        "filling",
        []() -> Result<std::string> {
            std::this_thread::sleep_for(60s);
            return std::string();
        },
        120s, progress);
    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().code, ErrorCode::Cancelled);
}

TEST(RunIsolated, PassesRefusalsAndOcctExceptionsOn) {
    const auto refused = run_isolated(
        "filling", []() -> Result<std::string> { return fail(ErrorCode::Refused, "edge 7"); }, 60s,
        {});
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().code, ErrorCode::Refused);
    EXPECT_EQ(refused.error().message, "edge 7");
    const auto thrown = run_isolated(
        "filling", []() -> Result<std::string> { throw Standard_DomainError("far"); }, 60s, {});
    ASSERT_FALSE(thrown);
    EXPECT_NE(thrown.error().message.find("Standard_DomainError"), std::string::npos);
}

}  // namespace
}  // namespace suture::occ

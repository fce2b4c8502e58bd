#include "suture/occ/isolate.h"

#include <gtest/gtest.h>
#include <sys/wait.h>

#include <chrono>
#include <thread>
#include <vector>

namespace suture::occ {
namespace {

using namespace std::chrono_literals;

Result<std::string> ask(const std::string& request, std::chrono::milliseconds limit = 60s,
                        const Progress& progress = {}) {
    return run_isolated("OCCT's filling", SUTURE_ISOLATED, request, limit, progress);
}

TEST(RunIsolated, BringsTheBytesThereAndBackAlsoManyOfThem) {
    std::string large(3'000'000, 'x');
    large[1'234'567] = '\0';
    const auto result = ask(large);
    ASSERT_TRUE(result) << result.error().message;
    EXPECT_EQ(*result, large);
}

TEST(RunIsolated, ReportsACrashBySignalName) {
    const auto result = ask("crash");
    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().code, ErrorCode::Internal);
    EXPECT_EQ(result.error().message, "OCCT's filling crashed (Segmentation fault)");
}

TEST(RunIsolated, NamesAProgramThatIsNotThere) {
    const auto result = run_isolated("OCCT's filling", "/none/such", "", 60s, {});
    ASSERT_FALSE(result);
    EXPECT_NE(result.error().message.find("/none/such"), std::string::npos);
}

TEST(RunIsolated, EndsAHangAtTheLimit) {
    const auto start = std::chrono::steady_clock::now();
    const auto result = ask("hang", 300ms);
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
    const auto result = ask("hang", 120s, progress);
    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().code, ErrorCode::Cancelled);
}

TEST(RunIsolated, PassesRefusalsAndOcctExceptionsOn) {
    const auto refused = ask("refuse");
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().code, ErrorCode::Refused);
    EXPECT_EQ(refused.error().message, "edge 7");
    const auto thrown = ask("throw");
    ASSERT_FALSE(thrown);
    EXPECT_NE(thrown.error().message.find("Standard_DomainError"), std::string::npos);
}

TEST(RunIsolated, AnswersManyThreadsAtOnce) {
    std::vector<std::string> answers(8);
    {
        std::vector<std::jthread> threads;
        for (std::size_t i = 0; i < answers.size(); ++i) {
            threads.emplace_back(
                [&, i] { answers[i] = ask(std::string(100'000 + i, 'a')).value_or("none"); });
        }
    }
    for (std::size_t i = 0; i < answers.size(); ++i) {
        EXPECT_EQ(answers[i].size(), 100'000 + i);
    }
}

}  // namespace
}  // namespace suture::occ

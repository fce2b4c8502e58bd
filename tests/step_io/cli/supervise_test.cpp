#include "cli/supervise.h"

#include "cli/exit_code.h"
#include "suture/platform/sanitized.h"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <fstream>
#include <stdexcept>
#include <thread>
#include <vector>

namespace suture::cli {
namespace {

using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;

constexpr auto kLong = 60s;

Ending run(const Job& job, std::chrono::milliseconds read_limit = kLong) {
    return supervise({read_limit, kLong, 0}, job);
}

/// Sends this process a signal after a while, as Ctrl-C does; blocked outside of supervise().
std::jthread signal_after(std::chrono::milliseconds delay, int signal) {
    return std::jthread([=] {
        std::this_thread::sleep_for(delay);
        kill(getpid(), signal);
    });
}

/// All threads of the test must have it blocked, or one of them would take the signal.
class Supervise : public testing::Test {
  protected:
    void SetUp() override {
        sigset_t stop;
        sigemptyset(&stop);
        sigaddset(&stop, SIGINT);
        sigaddset(&stop, SIGTERM);
        sigaddset(&stop, SIGCHLD);
        pthread_sigmask(SIG_BLOCK, &stop, nullptr);
    }
};

TEST_F(Supervise, PassesTheExitCodeOn) {
    const Ending ending = run([](const StageLine&, std::stop_token) { return 4; });
    EXPECT_EQ(ending.kind, Ending::Kind::Exited);
    EXPECT_EQ(ending.code, 4);
}

TEST_F(Supervise, TellsWhatACrashedJobWasDoing) {
    const Ending ending = run([](const StageLine& line, std::stop_token) {
        line.enter(Stage::Reading, "reading a.step");
        line.enter(Stage::Filling, "filling hole 3\nof many");
        raise(SIGSEGV);
        return 0;
    });
    EXPECT_EQ(ending.kind, Ending::Kind::Crashed);
    EXPECT_EQ(ending.code, SIGSEGV);
    EXPECT_EQ(ending.stage, Stage::Filling);
    EXPECT_EQ(ending.what, "filling hole 3 of many");
}

TEST_F(Supervise, StopsAReadThatTakesTooLong) {
    const auto start = Clock::now();
    const Ending ending = run(
        [](const StageLine& line, std::stop_token) {
            line.enter(Stage::Reading, "reading");
            std::this_thread::sleep_for(kLong);
            return 0;
        },
        300ms);
    EXPECT_EQ(ending.kind, Ending::Kind::ReadTimeout);
    EXPECT_LT(Clock::now() - start, 2s * SUTURE_TEST_SLOWDOWN);
}

TEST_F(Supervise, LimitsOnlyTheReading) {
    const Ending ending = run(
        [](const StageLine& line, std::stop_token) {
            line.enter(Stage::Reading, "reading");
            line.enter(Stage::Filling, "filling");
            std::this_thread::sleep_for(500ms);
            return 7;
        },
        200ms);
    EXPECT_EQ(ending.kind, Ending::Kind::Exited);
    EXPECT_EQ(ending.code, 7);
}

TEST_F(Supervise, GivesTheJobTimeToStopByItself) {
    const auto signal = signal_after(300ms, SIGINT);
    const Ending ending = run([](const StageLine&, std::stop_token cancel) {
        while (!cancel.stop_requested()) {
            std::this_thread::sleep_for(5ms);
        }
        return static_cast<int>(kInterrupted);
    });
    EXPECT_EQ(ending.kind, Ending::Kind::Interrupted);
    EXPECT_EQ(ending.code, SIGINT);
}

TEST_F(Supervise, KillsAJobThatDoesNotStop) {
    const auto signal = signal_after(200ms, SIGTERM);
    const auto start = Clock::now();
    const Ending ending = run([](const StageLine&, std::stop_token) {
        std::this_thread::sleep_for(kLong);
        return 0;
    });
    EXPECT_EQ(ending.kind, Ending::Kind::Interrupted);
    EXPECT_EQ(ending.code, SIGTERM);
    EXPECT_LT(Clock::now() - start, 2200ms * SUTURE_TEST_SLOWDOWN);
}

TEST_F(Supervise, KeepsTheResultOfAJobThatWasDoneBeforeItNoticed) {
    const auto signal = signal_after(200ms, SIGINT);
    const Ending ending = run([](const StageLine&, std::stop_token) {
        std::this_thread::sleep_for(600ms);
        return 0;
    });
    EXPECT_EQ(ending.kind, Ending::Kind::Exited);
    EXPECT_EQ(ending.code, 0);
}

TEST_F(Supervise, LeavesNoGrandchildBehind) {
    const std::string file = testing::TempDir() + "/grandchild";
    (void)run([&](const StageLine&, std::stop_token) {
        const pid_t grandchild = fork();
        if (grandchild == 0) {
            std::this_thread::sleep_for(kLong);
            _exit(0);
        }
        std::ofstream(file) << grandchild;
        return 0;
    });
    pid_t grandchild = 0;
    std::ifstream(file) >> grandchild;
    ASSERT_GT(grandchild, 0);
    // Killed, and taken by whoever takes orphans: it may be a zombie for a moment.
    bool gone = false;
    for (int i = 0; i < 200 && !gone; ++i) {
        std::ifstream stat("/proc/" + std::to_string(grandchild) + "/stat");
        std::string text;
        gone = !std::getline(stat, text) || text.find(") Z ") != std::string::npos;
        std::this_thread::sleep_for(10ms);
    }
    EXPECT_TRUE(gone);
}

TEST_F(Supervise, CostsLittle) {
    const auto start = Clock::now();
    (void)run([](const StageLine&, std::stop_token) { return 0; });
    EXPECT_LT(Clock::now() - start, 100ms * SUTURE_TEST_SLOWDOWN);
}

TEST_F(Supervise, EndsAJobWhoseWholeTimeIsOver) {
    const Ending ending = supervise({kLong, 200ms, 0}, [](const StageLine& line, std::stop_token) {
        line.enter(Stage::Filling, "filling hole 1");
        std::this_thread::sleep_for(kLong);
        return 0;
    });
    EXPECT_EQ(ending.kind, Ending::Kind::Timeout);
    EXPECT_EQ(ending.what, "filling hole 1");
}

TEST_F(Supervise, TellsAKillFromACrash) {
    const Ending ending = run([](const StageLine&, std::stop_token) {
        raise(SIGKILL);
        return 0;
    });
    EXPECT_EQ(ending.kind, Ending::Kind::Killed);
}

TEST_F(Supervise, TellsWhenMemoryWasNotEnough) {
    if (kSanitized) {
        GTEST_SKIP() << "a sanitizer takes terabytes of addresses";
    }
    // In a thread nobody catches it.
    constexpr std::uint64_t kLittle = 4'000'000'000;
    const Ending ending = supervise({kLong, kLong, kLittle}, [](const StageLine&, std::stop_token) {
        std::thread([] {
            const std::vector<char> much(10 * kLittle, 'x');
            std::ofstream("/dev/null") << much.back();
        }).join();
        return 0;
    });
    EXPECT_EQ(ending.kind, Ending::Kind::OutOfMemory);
}

TEST_F(Supervise, GivesTheJobNoCoreFileAndFewFiles) {
    const Ending ending = run([](const StageLine&, std::stop_token) {
        rlimit core{};
        rlimit files{};
        getrlimit(RLIMIT_CORE, &core);
        getrlimit(RLIMIT_NOFILE, &files);
        return core.rlim_cur == 0 && files.rlim_cur <= 1024 ? 0 : 1;
    });
    EXPECT_EQ(ending.code, 0);
}

}  // namespace
}  // namespace suture::cli

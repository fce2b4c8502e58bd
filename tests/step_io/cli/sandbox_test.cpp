#include "suture/platform/sandbox.h"

#include "files/atomic_file.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/ptrace.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <fstream>
#include <functional>

namespace suture::cli {
namespace {

namespace fs = std::filesystem;

/// A folder for reading and one for writing, and one for nothing.
class Sandbox : public testing::Test {
  protected:
    void SetUp() override {
        folder_ = fs::temp_directory_path() / ("suture_sandbox_test" + std::to_string(getpid()));
        for (const char* name : {"in", "out", "else"}) {
            fs::create_directories(folder_ / name);
            std::ofstream(folder_ / name / "file") << "old";
        }
    }
    void TearDown() override { fs::remove_all(folder_); }

    /// What `look` finds in the sandbox: true or false.
    bool within(const std::function<bool()>& look) const {
        const pid_t child = fork();
        if (child == 0) {
            enter_sandbox({{folder_ / "in"}, {folder_ / "out"}, {}});
            _exit(look() ? 0 : 1);
        }
        int status = 0;
        waitpid(child, &status, 0);
        EXPECT_TRUE(WIFEXITED(status));
        return WEXITSTATUS(status) == 0;
    }

    static bool has(const char* what) { return sandbox_support().find(what) != std::string::npos; }
    [[nodiscard]] bool opens(const char* file, int flags) const {
        const int opened = open((folder_ / file).c_str(), flags, 0600);
        return opened >= 0 && close(opened) == 0;
    }

    fs::path folder_;
};

TEST_F(Sandbox, OpensOnlyWhatItWasGiven) {
    if (!has("Landlock")) {
        GTEST_SKIP() << "the kernel has no Landlock";
    }
    EXPECT_TRUE(opens("else/file", O_RDONLY));
    EXPECT_TRUE(within([&] { return opens("in/file", O_RDONLY); }));
    EXPECT_TRUE(within([&] { return !opens("in/file", O_WRONLY) && errno == EACCES; }));
    EXPECT_TRUE(within([&] { return !opens("in/new", O_WRONLY | O_CREAT) && errno == EACCES; }));
    EXPECT_TRUE(within([&] { return !opens("else/file", O_RDONLY) && errno == EACCES; }));
    EXPECT_TRUE(within([&] { return !opens("in/../else/file", O_RDONLY); }));
    EXPECT_TRUE(within(
        [&] { return access("/etc/passwd", F_OK) != 0 || open("/etc/passwd", O_RDONLY) < 0; }));
    EXPECT_TRUE(within([] { return open("/dev/null", O_RDWR) >= 0; }));
}

TEST_F(Sandbox, ReplacesFilesWhereItMayWrite) {
    EXPECT_TRUE(within([&] {
        return io::write_atomically(
                   folder_ / "out" / "file",
                   [](std::ostream& stream) -> Result<void> {
                       stream << "new";
                       return {};
                   },
                   [](const fs::path& written) -> Result<void> {
                       std::string text;
                       std::ifstream(written) >> text;
                       return text == "new" ? Result<void>() : fail(ErrorCode::Internal, "");
                   })
            .has_value();
    }));
    std::string text;
    std::ifstream(folder_ / "out" / "file") >> text;
    EXPECT_EQ(text, "new");
}

TEST_F(Sandbox, HasNoSocketsAndNoDebugger) {
    if (!has("seccomp")) {
        GTEST_SKIP() << "the kernel has no seccomp";
    }
    EXPECT_TRUE(within([] { return socket(AF_INET, SOCK_STREAM, 0) < 0 && errno == EPERM; }));
    EXPECT_TRUE(within([] { return socket(AF_UNIX, SOCK_STREAM, 0) < 0 && errno == EPERM; }));
    EXPECT_TRUE(within([] { return ptrace(PTRACE_TRACEME, 0, 0, 0) < 0 && errno == EPERM; }));
}

TEST_F(Sandbox, StartsNoOtherProgram) {
    if (!has("Landlock")) {
        GTEST_SKIP() << "the kernel has no Landlock";
    }
    EXPECT_TRUE(within([] {
        execl("/bin/true", "true", nullptr);
        return errno == EACCES;
    }));
}

TEST_F(Sandbox, HoldsForWhatItStarts) {
    if (!has("Landlock")) {
        GTEST_SKIP() << "the kernel has no Landlock";
    }
    EXPECT_TRUE(within([&] {
        const pid_t child = fork();
        if (child == 0) {
            _exit(opens("else/file", O_RDONLY) ? 1 : 0);
        }
        int status = 0;
        waitpid(child, &status, 0);
        return status == 0;
    }));
}

}  // namespace
}  // namespace suture::cli

#include "suture/occ/isolate.h"

#include "suture/occ/guard.h"
#include "suture/platform/descriptor.h"
#include "suture/platform/process.h"

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <utility>

namespace suture::occ {
namespace {

using Clock = std::chrono::steady_clock;

/// The first byte of the answer.
constexpr char kValue = 'v';
constexpr char kError = 'e';

/// How often a waiting parent looks whether the user has cancelled.
constexpr std::chrono::milliseconds kCancelInterval{50};

/// Where a program finds the pipe for its answer.
constexpr int kAnswer = 3;

/// A file that closes itself. Those of this process are no other child's.
class File {
  public:
    explicit File(int file = -1) : file_(file) {}
    File(const File&) = delete;
    File& operator=(const File&) = delete;
    ~File() { reset(-1); }
    [[nodiscard]] int get() const { return file_; }
    void reset(int file) {
        if (file_ >= 0) {
            close(file_);
        }
        file_ = file;
    }

  private:
    int file_;
};

/// The child as it is started.
struct Child {
    pid_t id = -1;
    File answer;  ///< what it says, to be read
};

void write_all(int file, const std::string& bytes) {
    std::size_t done = 0;
    while (done < bytes.size()) {
        const ssize_t n = write(file, bytes.data() + done, bytes.size() - done);
        if (n < 0 && errno == EINTR) {
            continue;
        }
        if (n <= 0) {
            return;  // the other end is gone
        }
        done += static_cast<std::size_t>(n);
    }
}

std::string read_all(int file) {
    std::string bytes;
    std::array<char, 65536> buffer{};
    for (;;) {
        const ssize_t n = read(file, buffer.data(), buffer.size());
        if (n < 0 && errno == EINTR) {
            continue;
        }
        if (n <= 0) {
            return bytes;
        }
        bytes.append(buffer.data(), static_cast<std::size_t>(n));
    }
}

/// Starts the program with the request as its standard input; false: errno says why not.
bool start(const std::string& program, const std::string& request, Child& child) {
    const File input(make_memory_file("request"));
    std::array<int, 2> ends{};
    if (input.get() < 0 || pipe2(ends.data(), O_CLOEXEC) != 0) {
        return false;
    }
    child.answer.reset(ends[0]);
    const File output(ends[1]);
    write_all(input.get(), request);
    lseek(input.get(), 0, SEEK_SET);
    posix_spawn_file_actions_t files;
    posix_spawn_file_actions_init(&files);
    posix_spawn_file_actions_adddup2(&files, input.get(), STDIN_FILENO);
    posix_spawn_file_actions_adddup2(&files, STDERR_FILENO, STDOUT_FILENO);
    posix_spawn_file_actions_adddup2(&files, output.get(), kAnswer);
    std::string path = program;
    const std::array<char*, 2> arguments{path.data(), nullptr};
    const int error =
        posix_spawn(&child.id, program.c_str(), &files, nullptr, arguments.data(), environ);
    posix_spawn_file_actions_destroy(&files);
    errno = error;
    return error == 0;
}

Result<std::string> interpret(std::string_view what, const std::string& bytes, int status) {
    if (WIFSIGNALED(status)) {
        return fail(ErrorCode::Internal, "{} crashed ({})", what, strsignal(WTERMSIG(status)));
    }
    if (bytes.empty() || (bytes[0] == kError && bytes.size() < 2)) {
        return fail(ErrorCode::Internal, "{} ended without an answer", what);
    }
    if (bytes[0] == kError) {
        return tl::unexpected(Error{static_cast<ErrorCode>(bytes[1] - '0'), bytes.substr(2)});
    }
    return bytes.substr(1);
}

}  // namespace

Result<std::string> run_isolated(std::string_view what, const std::string& program,
                                 const std::string& request, std::chrono::milliseconds limit,
                                 const Progress& progress) {
    Child child;
    if (!start(program, request, child)) {
        return fail(ErrorCode::Internal, "{}: {} could not be started: {}", what, program,
                    std::strerror(errno));
    }
    const auto stop = [&] {
        kill(child.id, SIGKILL);
        waitpid(child.id, nullptr, 0);
    };
    std::string bytes;
    const auto deadline = Clock::now() + limit;
    for (;;) {
        const auto left =
            std::chrono::duration_cast<std::chrono::milliseconds>(deadline - Clock::now());
        if (left.count() <= 0) {
            stop();
            return fail(ErrorCode::Internal, "{} gave no answer within {:g} s", what,
                        static_cast<double>(limit.count()) / 1000.0);
        }
        if (progress.cancelled()) {
            stop();
            return fail(ErrorCode::Cancelled, "{} was stopped", what);
        }
        pollfd wait{child.answer.get(), POLLIN, 0};
        const int ready = poll(&wait, 1, static_cast<int>(std::min(left, kCancelInterval).count()));
        if (ready <= 0) {
            continue;
        }
        std::array<char, 65536> buffer{};
        const ssize_t n = read(child.answer.get(), buffer.data(), buffer.size());
        if (n < 0 && errno == EINTR) {
            continue;
        }
        if (n <= 0) {
            break;  // the child has closed its end: done, or dead
        }
        bytes.append(buffer.data(), static_cast<std::size_t>(n));
    }
    int status = 0;
    waitpid(child.id, &status, 0);
    return interpret(what, bytes, status);
}

int serve(std::string_view what,
          const std::function<Result<std::string>(const std::string& request)>& action) {
    end_with_parent(SIGKILL);
    const std::string request = read_all(STDIN_FILENO);
    const Result<std::string> result = guarded(what, [&] { return action(request); });
    if (result) {
        write_all(kAnswer, kValue + *result);
    } else {
        write_all(
            kAnswer,
            std::string{kError, static_cast<char>('0' + static_cast<int>(result.error().code))} +
                result.error().message);
    }
    return 0;
}

}  // namespace suture::occ

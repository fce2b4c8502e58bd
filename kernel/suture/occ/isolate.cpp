#include "suture/occ/isolate.h"

#include "suture/occ/guard.h"

#include <poll.h>
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

/// The first byte of the child's answer.
constexpr char kValue = 'v';
constexpr char kError = 'e';

/// How often a waiting parent looks whether the user has cancelled.
constexpr std::chrono::milliseconds kCancelInterval{50};

/// Both ends of a pipe, closed at the end of the scope.
class Pipe {
  public:
    Pipe() { open_ = pipe(ends_.data()) == 0; }
    Pipe(const Pipe&) = delete;
    Pipe& operator=(const Pipe&) = delete;
    ~Pipe() {
        close_end(0);
        close_end(1);
    }
    [[nodiscard]] bool is_open() const { return open_; }
    [[nodiscard]] int end(std::size_t which) const { return ends_[which]; }
    void close_end(std::size_t which) {
        if (open_ && ends_[which] >= 0) {
            close(ends_[which]);
            ends_[which] = -1;
        }
    }

  private:
    std::array<int, 2> ends_ = {-1, -1};
    bool open_ = false;
};

void write_all(int file, const std::string& bytes) {
    std::size_t done = 0;
    while (done < bytes.size()) {
        const ssize_t n = write(file, bytes.data() + done, bytes.size() - done);
        if (n < 0 && errno == EINTR) {
            continue;
        }
        if (n <= 0) {
            return;  // the parent is gone: nobody to answer
        }
        done += static_cast<std::size_t>(n);
    }
}

[[noreturn]] void answer(int file, std::string_view what,
                         const std::function<Result<std::string>()>& action) {
    const Result<std::string> result = guarded(what, action);
    if (result) {
        write_all(file, kValue + *result);
    } else {
        write_all(
            file,
            std::string{kError, static_cast<char>('0' + static_cast<int>(result.error().code))} +
                result.error().message);
    }
    _exit(0);  // no destructors: they belong to the parent
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

Result<std::string> run_isolated(std::string_view what,
                                 const std::function<Result<std::string>()>& action,
                                 std::chrono::milliseconds limit, const Progress& progress) {
    Pipe pipe;
    if (!pipe.is_open()) {
        return fail(ErrorCode::Internal, "{}: no pipe: {}", what, std::strerror(errno));
    }
    const pid_t child = fork();
    if (child < 0) {
        return fail(ErrorCode::Internal, "{}: no child process: {}", what, std::strerror(errno));
    }
    if (child == 0) {
        pipe.close_end(0);
        answer(pipe.end(1), what, action);
    }
    pipe.close_end(1);
    const auto stop = [&] {
        kill(child, SIGKILL);
        waitpid(child, nullptr, 0);
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
        pollfd wait{pipe.end(0), POLLIN, 0};
        const int ready = poll(&wait, 1, static_cast<int>(std::min(left, kCancelInterval).count()));
        if (ready <= 0) {
            continue;
        }
        std::array<char, 65536> buffer{};
        const ssize_t n = read(pipe.end(0), buffer.data(), buffer.size());
        if (n < 0 && errno == EINTR) {
            continue;
        }
        if (n <= 0) {
            break;  // the child has closed its end: done, or dead
        }
        bytes.append(buffer.data(), static_cast<std::size_t>(n));
    }
    int status = 0;
    waitpid(child, &status, 0);
    return interpret(what, bytes, status);
}

}  // namespace suture::occ

#include "cli/picture_broker.h"

#include "suture/platform/process.h"

#include "report/picture.h"
#include <poll.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <stop_token>
#include <thread>

namespace suture::cli {
namespace {

/// How often a waiting job looks whether the user has cancelled.
constexpr int kInterval = 50;  // ms

bool transfer(int line, char* bytes, std::size_t size, bool sends) {
    while (size > 0) {
        const ssize_t n = sends ? write(line, bytes, size) : read(line, bytes, size);
        if (n < 0 && errno == EINTR) {
            continue;
        }
        if (n <= 0) {
            return false;
        }
        bytes += n;
        size -= static_cast<std::size_t>(n);
    }
    return true;
}

/// A message is its length and its bytes.
bool send(int line, std::string message) {
    std::uint64_t size = message.size();
    return transfer(line, reinterpret_cast<char*>(&size), sizeof size, true) &&
           transfer(line, message.data(), message.size(), true);
}

bool receive(int line, std::string& message) {
    std::uint64_t size = 0;
    if (!transfer(line, reinterpret_cast<char*>(&size), sizeof size, false)) {
        return false;
    }
    message.resize(size);
    return transfer(line, message.data(), message.size(), false);
}

/// An answer is empty, or an error's code and message.
std::string answer_of(const Result<void>& taken) {
    return taken ? ""
                 : std::string(1, static_cast<char>('0' + static_cast<int>(taken.error().code))) +
                       taken.error().message;
}

[[noreturn]] void serve(int line, const CommonOptions& wanted) {
    constexpr std::chrono::seconds kLimit(120);
    sigset_t stop;
    sigemptyset(&stop);
    for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
        sigaddset(&stop, signal);
    }
    pthread_sigmask(SIG_BLOCK, &stop, nullptr);
    std::signal(SIGPIPE, SIG_IGN);
    end_with_parent(SIGTERM);
    static std::stop_source source;
    static std::atomic<bool> busy = false;
    std::thread([stop] {
        int signal = 0;
        while (sigwait(&stop, &signal) == 0) {
            source.request_stop();
            if (!busy) {
                _exit(0);
            }
        }
    }).detach();
    Progress progress;
    progress.cancel = source.get_token();
    std::string page;
    while (!source.stop_requested() && receive(line, page)) {
        busy = true;
        const auto taken =
            report::take_picture(page, wanted.picture_wish, wanted.picture, kLimit, progress);
        send(line, answer_of(taken));
        busy = false;
    }
    _exit(0);
}

}  // namespace

PictureBroker::PictureBroker(const Command& command) {
    std::array<int, 2> ends{};
    if (command.common.picture.empty() ||
        socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0) {
        return;
    }
    process_ = fork();
    if (process_ == 0) {
        close(ends[0]);
        serve(ends[1], command.common);
    }
    close(ends[1]);
    line_ = ends[0];
}

PictureBroker::~PictureBroker() {
    if (process_ > 0) {
        kill(process_, SIGTERM);
        waitpid(process_, nullptr, 0);
    }
    if (line_ >= 0) {
        close(line_);
    }
}

Result<void> PictureBroker::take(const std::string& page, const Progress& progress) const {
    std::string answer;
    if (process_ < 0 || !send(line_, page)) {
        return fail(ErrorCode::Internal, "there is no process to take the picture");
    }
    for (pollfd wait{line_, POLLIN, 0}; poll(&wait, 1, kInterval) <= 0;) {
        if (progress.cancelled()) {
            return fail(ErrorCode::Cancelled, "taking the picture was stopped");
        }
    }
    if (!receive(line_, answer)) {
        return fail(ErrorCode::Internal, "the process that takes pictures has ended");
    }
    if (!answer.empty()) {
        return tl::unexpected(
            Error{static_cast<ErrorCode>(answer.front() - '0'), answer.substr(1)});
    }
    return {};
}

}  // namespace suture::cli

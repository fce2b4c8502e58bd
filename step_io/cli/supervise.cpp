#include "cli/supervise.h"

#include "cli/exit_code.h"
#include "suture/platform/process.h"
#include "suture/platform/sanitized.h"
#include "suture/platform/signal_file.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <exception>
#include <fstream>
#include <new>
#include <optional>
#include <system_error>
#include <thread>

namespace suture::cli {
namespace {

using Clock = std::chrono::steady_clock;

/// From the wish to stop to the end by force: with it, everything ends within two seconds.
constexpr std::chrono::milliseconds kGrace{1500};

/// A message is its stage, its text and this; one write of less than PIPE_BUF bytes is atomic.
constexpr char kEndOfMessage = '\n';
constexpr char kNoMemory = '!';  ///< in the place of the stage
constexpr std::size_t kLongestText = 400;

/// The exit code of a job that got no thread: none of its own.
constexpr int kNoThread = 77;

/// In the job's process: for what has no other way to it.
const StageLine* job_line = nullptr;

sigset_t set_of(std::initializer_list<int> signals) {
    sigset_t set;
    sigemptyset(&set);
    for (const int signal : signals) {
        sigaddset(&set, signal);
    }
    return set;
}

/// Waits in a thread of its own for the signal to stop: a handler could not request a stop safely.
void listen_for_stop(std::stop_source& source) {
    std::thread([&source] {
        const sigset_t stop = set_of({SIGINT, SIGTERM, SIGHUP});
        int signal = 0;
        while (sigwait(&stop, &signal) == 0) {
            source.request_stop();
        }
    }).detach();
}

void limit(decltype(RLIMIT_AS) what, std::uint64_t most) {
    rlimit now{};
    if (getrlimit(what, &now) == 0) {
        now.rlim_max = std::min<rlim_t>(now.rlim_max, most);
        now.rlim_cur = std::min(now.rlim_cur, now.rlim_max);
        setrlimit(what, &now);
    }
}

void obey(const JobLimits& limits) {
    constexpr std::uint64_t kFiles = 1024;
    limit(RLIMIT_CORE, 0);
    limit(RLIMIT_NOFILE, kFiles);
    const auto seconds = std::chrono::ceil<std::chrono::seconds>(limits.whole).count();
    limit(RLIMIT_CPU, static_cast<std::uint64_t>(seconds + 1) *
                          std::max(1U, std::thread::hardware_concurrency()));
    if (limits.memory > 0 && !kSanitized) {
        limit(RLIMIT_AS, limits.memory);
    }
}

/// What every other allocation comes to when there is no memory left.
void say_and_give_up() {
    job_line->lack_memory();
    throw std::bad_alloc();
}

/// An exception in a thread that nobody waits for: no memory, or no thread. Without a core file and
/// without libstdc++'s lines on stderr.
[[noreturn]] void end_by_abort() {
    std::signal(SIGABRT, SIG_DFL);
    std::abort();
}

[[noreturn]] void be_the_job(pid_t supervisor, int line, const JobLimits& limits, const Job& job) {
    setpgid(0, 0);
    end_with_parent(SIGKILL);
    if (getppid() != supervisor) {
        _exit(kInternal);  // it died before the line above
    }
    std::signal(SIGTTOU, SIG_IGN);  // a group in the background may write to its terminal
    const sigset_t handled = set_of({SIGCHLD, SIGTSTP});
    sigprocmask(SIG_UNBLOCK, &handled, nullptr);
    static const StageLine to_supervisor(line);
    job_line = &to_supervisor;
    std::set_new_handler(say_and_give_up);
    std::set_terminate(end_by_abort);
    obey(limits);
    static std::stop_source source;
    try {
        listen_for_stop(source);
    } catch (const std::system_error& error) {
        _exit(kNoThread);
    }
    const int code = job(to_supervisor, source.get_token());
    _exit(code);  // OCCT's static objects need no destruction, and theirs has crashed before
}

/// The supervisor's side.
class Supervisor {
  public:
    Supervisor(pid_t job, int line, int signals, const JobLimits& limits)
        : job_(job),
          line_(line),
          signals_(signals),
          limits_(limits),
          end_(Clock::now() + limits.whole) {}

    Ending watch() {
        while (!ended()) {
            wait_for_news();
            if (Clock::now() >= next_deadline()) {
                timed_out_ = !stop_signal_;
                killed_ = true;
                kill(-job_, SIGKILL);
            }
        }
        read_messages();
        kill(-job_, SIGKILL);  // what the job has left behind
        int status = 0;
        waitpid(job_, &status, 0);
        return interpret(status);
    }

  private:
    [[nodiscard]] bool ended() const {
        siginfo_t info{};
        waitid(P_PID, static_cast<id_t>(job_), &info, WEXITED | WNOHANG | WNOWAIT);
        return info.si_pid == job_;
    }

    /// Of the grace period, or else of the stage or the whole; none once the job is killed.
    [[nodiscard]] Clock::time_point next_deadline() const {
        if (killed_) {
            return Clock::time_point::max();
        }
        if (stop_signal_) {
            return *deadline_;
        }
        return deadline_ ? std::min(*deadline_, end_) : end_;
    }

    void wait_for_news() {
        std::array<pollfd, 2> files{{{line_open_ ? line_ : -1, POLLIN, 0}, {signals_, POLLIN, 0}}};
        constexpr std::chrono::milliseconds kLongest{1000};  // should a signal get lost
        const Clock::time_point deadline = next_deadline();
        const auto left =
            deadline == Clock::time_point::max()
                ? kLongest
                : std::chrono::ceil<std::chrono::milliseconds>(deadline - Clock::now());
        const auto timeout = std::clamp(left, std::chrono::milliseconds{0}, kLongest);
        if (poll(files.data(), files.size(), static_cast<int>(timeout.count())) <= 0) {
            return;
        }
        if (files[0].revents != 0) {
            read_messages();
        }
        if (files[1].revents != 0) {
            take_signal();
        }
    }

    void read_messages() {
        std::array<char, 4096> buffer{};
        ssize_t n = 0;
        while ((n = read(line_, buffer.data(), buffer.size())) > 0) {
            for (const char c : std::string_view(buffer.data(), static_cast<std::size_t>(n))) {
                take(c);
            }
        }
        if (n == 0) {
            line_open_ = false;
        }
    }

    void take(char c) {
        if (c != kEndOfMessage) {
            message_ += c;
        } else if (message_ == std::string(1, kNoMemory)) {
            lacks_memory_ = true;
            message_.clear();
        } else if (!message_.empty()) {
            enter(static_cast<Stage>(message_[0] - 'a'), message_.substr(1));
            message_.clear();
        }
    }

    void enter(Stage stage, std::string what) {
        const bool was_reading = stage_ == Stage::Reading;
        stage_ = stage;
        what_ = std::move(what);
        if (stop_signal_) {
            return;  // the deadline is that of the grace period
        }
        if (stage != Stage::Reading) {
            deadline_.reset();
        } else if (!was_reading) {
            deadline_ = Clock::now() + limits_.reading;
        }
    }

    void take_signal() {
        const int signal = suture::take_signal(signals_);
        if (signal == 0) {
            return;
        }
        if (signal == SIGTSTP) {
            suspend();
        } else if (signal != SIGCHLD) {
            kill(-job_, signal);
            if (!stop_signal_) {
                stop_signal_ = signal;
                deadline_ = Clock::now() + kGrace;
            }
        }
    }

    /// Ctrl-Z: the job stops with us, goes on with us, and the pause does not count.
    void suspend() {
        const auto before = Clock::now();
        kill(-job_, SIGSTOP);
        raise(SIGSTOP);
        kill(-job_, SIGCONT);
        const auto pause = Clock::now() - before;
        end_ += pause;
        if (deadline_) {
            *deadline_ += pause;
        }
    }

    [[nodiscard]] Ending interpret(int status) const {
        Ending ending{Ending::Kind::Exited, 0, stage_, what_, job_};
        if (WIFEXITED(status)) {
            ending.code = WEXITSTATUS(status);
            if (ending.code == kNoThread) {
                ending.kind = Ending::Kind::NotStarted;
                ending.code = EAGAIN;
            }
        } else {
            ending.code = WTERMSIG(status);
            ending.kind = ending.code == SIGKILL   ? Ending::Kind::Killed
                          : lacks_memory_          ? Ending::Kind::OutOfMemory
                          : ending.code == SIGXCPU ? Ending::Kind::Timeout
                                                   : Ending::Kind::Crashed;
        }
        if (timed_out_) {
            const bool reading = deadline_ && *deadline_ <= end_;
            ending.kind = reading ? Ending::Kind::ReadTimeout : Ending::Kind::Timeout;
        } else if (stop_signal_ && (!WIFEXITED(status) || ending.code == kInterrupted)) {
            ending.kind = Ending::Kind::Interrupted;
            ending.code = *stop_signal_;
        }
        return ending;
    }

    pid_t job_;
    int line_;
    int signals_;
    JobLimits limits_;
    Clock::time_point end_;
    bool line_open_ = true;
    bool timed_out_ = false;
    bool killed_ = false;  ///< by us
    bool lacks_memory_ = false;
    std::optional<int> stop_signal_;
    std::optional<Clock::time_point> deadline_;
    std::string message_;
    Stage stage_ = Stage::Start;
    std::string what_ = "starting";
};

}  // namespace

void StageLine::enter(Stage stage, std::string_view what) const {
    std::string message(1, static_cast<char>('a' + static_cast<int>(stage)));
    message += what.substr(0, kLongestText);
    for (char& c : message) {
        if (c == kEndOfMessage) {
            c = ' ';
        }
    }
    message += kEndOfMessage;
    // Without a supervisor there is nobody to tell, and the job is about to die anyway.
    [[maybe_unused]] const ssize_t written = write(file_, message.data(), message.size());
}

void StageLine::lack_memory() const {
    constexpr std::array<char, 2> message{kNoMemory, kEndOfMessage};
    [[maybe_unused]] const ssize_t written = write(file_, message.data(), message.size());
}

std::uint64_t default_memory_limit() {
    return memory_of_machine() / 4 * 3;
}

Ending supervise(const JobLimits& limits, const Job& job) {
    const sigset_t handled = set_of({SIGINT, SIGTERM, SIGHUP, SIGTSTP, SIGCHLD});
    sigset_t before;
    sigprocmask(SIG_BLOCK, &handled, &before);
    std::signal(SIGPIPE, SIG_IGN);  // a reader that has seen enough of our output is no crash
    std::array<int, 2> line{};
    const int signals = open_signal_file(handled);
    if (signals < 0 || pipe2(line.data(), O_CLOEXEC | O_NONBLOCK) != 0) {
        return {Ending::Kind::NotStarted, errno, Stage::Start, {}, 0};
    }
    const pid_t supervisor = getpid();
    const pid_t child = fork();
    if (child < 0) {
        return {Ending::Kind::NotStarted, errno, Stage::Start, {}, 0};
    }
    if (child == 0) {
        close(line[0]);
        close(signals);
        be_the_job(supervisor, line[1], limits, job);
    }
    setpgid(child, child);  // here as well, so that no signal can come before it
    close(line[1]);
    Ending ending = Supervisor(child, line[0], signals, limits).watch();
    close(line[0]);
    close(signals);
    sigprocmask(SIG_SETMASK, &before, nullptr);
    return ending;
}

}  // namespace suture::cli

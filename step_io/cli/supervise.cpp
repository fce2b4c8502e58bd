#include "cli/supervise.h"

#include "cli/exit_code.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/signalfd.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <optional>
#include <thread>

namespace suture::cli {
namespace {

using Clock = std::chrono::steady_clock;

/// From the wish to stop to the end by force: with it, everything ends within two seconds.
constexpr std::chrono::milliseconds kGrace{1500};

/// A message is its stage, its text and this; one write of less than PIPE_BUF bytes is atomic.
constexpr char kEndOfMessage = '\n';
constexpr std::size_t kLongestText = 400;

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

[[noreturn]] void be_the_job(pid_t supervisor, int line, const Job& job) {
    setpgid(0, 0);
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (getppid() != supervisor) {
        _exit(kInternal);  // it died before the line above
    }
    std::signal(SIGTTOU, SIG_IGN);  // a group in the background may write to its terminal
    const sigset_t handled = set_of({SIGCHLD, SIGTSTP});
    sigprocmask(SIG_UNBLOCK, &handled, nullptr);
    static std::stop_source source;
    listen_for_stop(source);
    const int code = job(StageLine(line), source.get_token());
    _exit(code);  // OCCT's static objects need no destruction, and theirs has crashed before
}

/// The supervisor's side.
class Supervisor {
  public:
    Supervisor(pid_t job, int line, int signals, std::chrono::milliseconds read_limit)
        : job_(job), line_(line), signals_(signals), read_limit_(read_limit) {}

    Ending watch() {
        while (!ended()) {
            wait_for_news();
            if (deadline_ && Clock::now() >= *deadline_) {
                timed_out_ = !stop_signal_;
                kill(-job_, SIGKILL);
                deadline_.reset();
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

    void wait_for_news() {
        std::array<pollfd, 2> files{{{line_open_ ? line_ : -1, POLLIN, 0}, {signals_, POLLIN, 0}}};
        int timeout = -1;
        if (deadline_) {
            const auto left =
                std::chrono::ceil<std::chrono::milliseconds>(*deadline_ - Clock::now());
            timeout = std::max(0, static_cast<int>(left.count()));
        }
        if (poll(files.data(), files.size(), timeout) <= 0) {
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
            deadline_ = Clock::now() + read_limit_;
        }
    }

    void take_signal() {
        signalfd_siginfo info{};
        if (read(signals_, &info, sizeof info) != sizeof info) {
            return;
        }
        const int signal = static_cast<int>(info.ssi_signo);
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
        if (deadline_) {
            *deadline_ += Clock::now() - before;
        }
    }

    [[nodiscard]] Ending interpret(int status) const {
        Ending ending{Ending::Kind::Exited, 0, stage_, what_, job_};
        if (WIFEXITED(status)) {
            ending.code = WEXITSTATUS(status);
        } else {
            ending.kind = Ending::Kind::Crashed;
            ending.code = WTERMSIG(status);
        }
        if (timed_out_) {
            ending.kind = Ending::Kind::ReadTimeout;
        } else if (stop_signal_ && (!WIFEXITED(status) || ending.code == kInterrupted)) {
            ending.kind = Ending::Kind::Interrupted;
            ending.code = *stop_signal_;
        }
        return ending;
    }

    pid_t job_;
    int line_;
    int signals_;
    std::chrono::milliseconds read_limit_;
    bool line_open_ = true;
    bool timed_out_ = false;
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

Ending supervise(std::chrono::milliseconds read_limit, const Job& job) {
    const sigset_t handled = set_of({SIGINT, SIGTERM, SIGHUP, SIGTSTP, SIGCHLD});
    sigset_t before;
    sigprocmask(SIG_BLOCK, &handled, &before);
    std::signal(SIGPIPE, SIG_IGN);  // a reader that has seen enough of our output is no crash
    std::array<int, 2> line{};
    const int signals = signalfd(-1, &handled, SFD_CLOEXEC);
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
        be_the_job(supervisor, line[1], job);
    }
    setpgid(child, child);  // here as well, so that no signal can come before it
    close(line[1]);
    Ending ending = Supervisor(child, line[0], signals, read_limit).watch();
    close(line[0]);
    close(signals);
    sigprocmask(SIG_SETMASK, &before, nullptr);
    return ending;
}

}  // namespace suture::cli

#include "cli/batch_process.h"

#include "suture/platform/process.h"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>

namespace suture::cli {
namespace {

constexpr int kSignalBase = 128;  // as shells have it

sigset_t handled_signals() {
    sigset_t set;
    sigemptyset(&set);
    for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGCHLD}) {
        sigaddset(&set, signal);
    }
    return set;
}

std::string content_of(FILE* file) {
    std::string text;
    std::rewind(file);
    std::array<char, 65536> buffer{};
    for (std::size_t n = 0; (n = std::fread(buffer.data(), 1, buffer.size(), file)) > 0;) {
        text.append(buffer.data(), n);
    }
    return text;
}

[[noreturn]] void be_the_program(int supervisor, int out, int err, std::vector<char*> words) {
    end_with_parent(SIGTERM);
    if (getppid() != supervisor) {
        _exit(kSignalBase + SIGTERM);  // it died before the line above
    }
    const sigset_t handled = handled_signals();
    sigprocmask(SIG_UNBLOCK, &handled, nullptr);
    const int nothing = open("/dev/null", O_RDONLY | O_CLOEXEC);
    dup2(nothing, STDIN_FILENO);
    dup2(out, STDOUT_FILENO);
    dup2(err, STDERR_FILENO);
    execv(kOwnProgram, words.data());
    _exit(kSignalBase - 1);
}

}  // namespace

BatchProcesses::BatchProcesses() {
    const sigset_t handled = handled_signals();
    sigprocmask(SIG_BLOCK, &handled, nullptr);
}

BatchProcesses::~BatchProcesses() {
    for (const Running& one : running_) {
        kill(one.process, SIGTERM);
        waitpid(one.process, nullptr, 0);
    }
}

int BatchProcesses::start(std::size_t item, const std::vector<std::string>& words) {
    File out(std::tmpfile(), std::fclose);
    File err(std::tmpfile(), std::fclose);
    if (!out || !err) {
        return errno;
    }
    std::vector<std::string> all{"suture"};
    all.insert(all.end(), words.begin(), words.end());
    std::vector<char*> pointers;
    for (std::string& word : all) {
        pointers.push_back(word.data());
    }
    pointers.push_back(nullptr);
    const int supervisor = getpid();
    const int out_file = fileno(out.get());
    const int err_file = fileno(err.get());
    fcntl(out_file, F_SETFD, FD_CLOEXEC);  // the other processes need not have them
    fcntl(err_file, F_SETFD, FD_CLOEXEC);
    const pid_t process = fork();
    if (process < 0) {
        return errno;
    }
    if (process == 0) {
        be_the_program(supervisor, out_file, err_file, std::move(pointers));
    }
    running_.push_back(
        {process, item, std::move(out), std::move(err), std::chrono::steady_clock::now()});
    return 0;
}

std::optional<BatchProcesses::Ended> BatchProcesses::reap() {
    for (auto one = running_.begin(); one != running_.end(); ++one) {
        int status = 0;
        if (waitpid(one->process, &status, WNOHANG) != one->process) {
            continue;
        }
        Ended ended;
        ended.item = one->item;
        ended.code = WIFEXITED(status) ? WEXITSTATUS(status) : kSignalBase + WTERMSIG(status);
        ended.printed = content_of(one->out.get());
        ended.said = content_of(one->err.get());
        ended.seconds =
            std::chrono::duration<double>(std::chrono::steady_clock::now() - one->start).count();
        running_.erase(one);
        return ended;
    }
    return std::nullopt;
}

BatchProcesses::Ended BatchProcesses::wait() {
    const sigset_t handled = handled_signals();
    while (true) {
        if (std::optional<Ended> ended = reap()) {
            return std::move(*ended);
        }
        const int signal = sigwaitinfo(&handled, nullptr);
        if (signal > 0 && signal != SIGCHLD) {
            stop_signal_ = stop_signal_.value_or(signal);
            for (const Running& one : running_) {
                kill(one.process, SIGTERM);
            }
        }
    }
}

}  // namespace suture::cli

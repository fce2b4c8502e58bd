#pragma once

#include <chrono>
#include <functional>
#include <stop_token>
#include <string>
#include <string_view>

namespace suture::cli {

/// What a job is doing, for the line that is printed when it dies doing it.
enum class Stage : char { Start, Reading, Finding, Filling, Writing, Checking };

/// The job's line to its supervisor.
class StageLine {
  public:
    explicit StageLine(int file) : file_(file) {}

    /// what: reads on from "the program crashed while ...": "filling hole 3".
    void enter(Stage stage, std::string_view what) const;

  private:
    int file_;
};

/// How a supervised job ended.
struct Ending {
    enum class Kind {
        Exited,       ///< by itself, with `code`
        Crashed,      ///< by the signal `code`
        ReadTimeout,  ///< stopped because reading took too long
        Interrupted,  ///< by the user's signal `code`, which the supervisor has passed on
        NotStarted,   ///< the system gave no process; `code` is its errno
    };
    Kind kind = Kind::Exited;
    int code = 0;
    Stage stage = Stage::Start;
    std::string what;  ///< what the job was doing at last
    int process = 0;   ///< the job's process id, while it lived
};

using Job = std::function<int(const StageLine& line, std::stop_token cancel)>;

/// Runs a job in a child process in a process group of its own, and watches it, so that a crash or
/// a hang of OCCT in there ends in a message and an exit code of this program.
///
/// Input    read_limit: how long the stage Reading may last; then the group is killed.
/// Promises a signal to stop (INT, TERM, HUP) is passed on: the job's `cancel` is requested, and
///          1.5 s later the whole group is killed. When this returns, no process of the job is
///          left. Ctrl-Z and fg hold for the whole group. The job dies with its supervisor.
[[nodiscard]] Ending supervise(std::chrono::milliseconds read_limit, const Job& job);

}  // namespace suture::cli

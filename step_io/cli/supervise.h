#pragma once

#include <chrono>
#include <cstdint>
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

    /// That there was no memory; allocates none itself.
    void lack_memory() const;

  private:
    int file_;
};

/// How a supervised job ended.
struct Ending {
    enum class Kind {
        Exited,       ///< by itself, with `code`
        Crashed,      ///< by the signal `code`
        Killed,       ///< by a SIGKILL that was not ours: as a rule the system's, out of memory
        OutOfMemory,  ///< it wanted more than its limit, and could not go on without
        ReadTimeout,  ///< stopped because reading took too long
        Timeout,      ///< stopped because all took too long
        Interrupted,  ///< by the user's signal `code`, which the supervisor has passed on
        NotStarted,   ///< the system gave no process; `code` is its errno
    };
    Kind kind = Kind::Exited;
    int code = 0;
    Stage stage = Stage::Start;
    std::string what;  ///< what the job was doing at last
    int process = 0;   ///< the job's process id, while it lived
};

/// What a job may take.
struct JobLimits {
    std::chrono::milliseconds reading{300'000};  ///< for each stage Reading
    std::chrono::milliseconds whole{7'200'000};  ///< for all of it
    std::uint64_t memory = 0;                    ///< bytes of address space; 0: no limit
};

/// Three quarters of the machine's memory, or of what its control group may take.
[[nodiscard]] std::uint64_t default_memory_limit();

using Job = std::function<int(const StageLine& line, std::stop_token cancel)>;

/// Runs a job in a child process in a process group of its own, and watches it, so that a crash or
/// a hang of OCCT in there ends in a message and an exit code of this program.
///
/// Input    limits: when a time is over, the whole group is killed; memory that goes beyond its
///          limit is refused by the system. The job leaves no core file, has at most 1,024 files
///          open, and at most the processor time of all cores for the whole time.
/// Promises a signal to stop (INT, TERM, HUP) is passed on: the job's `cancel` is requested, and
///          1.5 s later the whole group is killed. When this returns, no process of the job is
///          left. Ctrl-Z and fg hold for the whole group. The job dies with its supervisor.
[[nodiscard]] Ending supervise(const JobLimits& limits, const Job& job);

}  // namespace suture::cli

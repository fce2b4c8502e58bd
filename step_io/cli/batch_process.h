#pragma once

#include <chrono>
#include <cstdio>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace suture::cli {

/// The files of a batch as processes: each runs this program with words of its own, and dies with
/// this one.
class BatchProcesses {
  public:
    /// What a process left behind.
    struct Ended {
        std::size_t item = 0;
        int code = 0;  ///< 128 and the signal if one ended it
        std::string printed, said;
        double seconds = 0.0;
    };

    /// Takes over the signals SIGINT, SIGTERM, SIGHUP and SIGCHLD of this process.
    BatchProcesses();
    BatchProcesses(const BatchProcesses&) = delete;
    BatchProcesses& operator=(const BatchProcesses&) = delete;
    /// Ends what still runs.
    ~BatchProcesses();

    /// Result  0, or the errno if the system gives no process.
    [[nodiscard]] int start(std::size_t item, const std::vector<std::string>& words);
    [[nodiscard]] std::size_t running() const { return running_.size(); }

    /// Waits until one has ended. After a signal to stop, all that run are asked to end.
    [[nodiscard]] Ended wait();
    [[nodiscard]] std::optional<int> stop_signal() const { return stop_signal_; }

  private:
    using File = std::unique_ptr<FILE, int (*)(FILE*)>;
    struct Running {
        int process = 0;
        std::size_t item = 0;
        File out, err;
        std::chrono::steady_clock::time_point start;
    };

    [[nodiscard]] std::optional<Ended> reap();

    std::vector<Running> running_;
    std::optional<int> stop_signal_;
};

}  // namespace suture::cli

#pragma once

#include "suture/base/progress.h"
#include "suture/base/result.h"

#include <chrono>
#include <mutex>
#include <string>
#include <string_view>

namespace suture::cli {

/// One line of at most 300 letters on stderr: "error: ...". What would steer the terminal is made
/// visible; what is left out of a longer one stands in the JSON document.
void print_error(std::string_view message);
void print_warning(std::string_view message);  ///< unless be_quiet was called
void be_quiet();

/// Standard output, kept for the result alone: from construction on, what a library writes to file
/// descriptor 1 goes to stderr if `verbose`, or else nowhere.
class ResultStream {
  public:
    explicit ResultStream(bool verbose);
    ResultStream(const ResultStream&) = delete;
    ResultStream& operator=(const ResultStream&) = delete;
    ~ResultStream();

    /// Refuses (WriteFailed) what could not be written, on a full disk for example. That nobody
    /// listens, at a closed descriptor or a pipe, is no failure.
    [[nodiscard]] Result<void> print(std::string_view text) const;

  private:
    int file_;
};

enum class ProgressStyle { Auto, None, Bar, Json };

/// Shows on stderr how far the run is: a bar on a terminal, or one line of JSON per step:
/// {"progress":0.3,"stage":"filling hole 3"}. Thread safe.
class ProgressDisplay {
  public:
    explicit ProgressDisplay(ProgressStyle style);
    ProgressDisplay(const ProgressDisplay&) = delete;
    ProgressDisplay& operator=(const ProgressDisplay&) = delete;
    ~ProgressDisplay();

    /// fraction of the whole run, in [0,1]; one that goes backwards is shown as standing still
    void show(double fraction, std::string_view stage);
    /// Takes the bar off the terminal, so that text can follow.
    void clear();

  private:
    using Clock = std::chrono::steady_clock;

    void draw(double fraction, std::string_view stage);

    ProgressStyle style_;
    std::mutex mutex_;
    double fraction_ = 0.0;
    std::string stage_;
    Clock::time_point shown_at_{};
    bool visible_ = false;
};

/// Makes spdlog write to stderr: warnings, with verbose everything, when quiet errors alone.
void set_up_log(bool verbose);

}  // namespace suture::cli

#include "cli/console.h"

#include "suture/base/text.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <spdlog/pattern_formatter.h>
#include <spdlog/sinks/stdout_sinks.h>
#include <spdlog/spdlog.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>

namespace suture::cli {
namespace {

/// A bar that changes more often than the eye sees costs time only.
constexpr std::chrono::milliseconds kRedrawInterval{80};
constexpr int kBarWidth = 28;
constexpr int kUsualTerminalWidth = 80;
constexpr std::string_view kEraseLine = "\r\x1b[K";

bool is_quiet = false;

/// Result  0, or the errno that ended it.
int write_all(int file, std::string_view text) {
    while (!text.empty()) {
        const ssize_t n = write(file, text.data(), text.size());
        if (n < 0 && errno == EINTR) {
            continue;
        }
        if (n <= 0) {
            return n < 0 ? errno : EIO;
        }
        text.remove_prefix(static_cast<std::size_t>(n));
    }
    return 0;
}

void print_line(std::string_view prefix, std::string_view message) {
    constexpr std::size_t kLongestLine = 300;
    std::string text(message);
    std::replace_if(
        text.begin(), text.end(), [](char c) { return c == '\n' || c == '\r' || c == '\t'; }, ' ');
    write_all(STDERR_FILENO,
              shortened(fmt::format("{}{}", prefix, visible(text)), kLongestLine) + '\n');
}

/// What the log says, made visible like everything else.
class VisiblePayload : public spdlog::custom_flag_formatter {
  public:
    void format(const spdlog::details::log_msg& message, const std::tm& /*time*/,
                spdlog::memory_buf_t& to) override {
        const std::string text = visible({message.payload.data(), message.payload.size()});
        to.append(text.data(), text.data() + text.size());
    }
    [[nodiscard]] std::unique_ptr<custom_flag_formatter> clone() const override {
        return std::make_unique<VisiblePayload>();
    }
};

int terminal_width() {
    winsize size{};
    const bool known = ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0;
    return known ? size.ws_col : kUsualTerminalWidth;
}

ProgressStyle resolve(ProgressStyle style) {
    if (style != ProgressStyle::Auto) {
        return style;
    }
    return isatty(STDERR_FILENO) != 0 ? ProgressStyle::Bar : ProgressStyle::None;
}

}  // namespace

void print_error(std::string_view message) {
    print_line("error: ", message);
}

void print_warning(std::string_view message) {
    if (!is_quiet) {
        print_line("warning: ", message);
    }
}

void be_quiet() {
    is_quiet = true;
}

ResultStream::ResultStream(bool verbose) : file_(dup(STDOUT_FILENO)) {
    if (verbose) {
        dup2(STDERR_FILENO, STDOUT_FILENO);
        return;
    }
    const int nowhere = open("/dev/null", O_WRONLY | O_CLOEXEC);
    dup2(nowhere, STDOUT_FILENO);
    close(nowhere);
}

ResultStream::~ResultStream() {
    std::fflush(stdout);
    dup2(file_, STDOUT_FILENO);
    close(file_);
}

Result<void> ResultStream::print(std::string_view text) const {
    const int error = write_all(file_, text);
    if (error == 0 || error == EBADF || error == EPIPE) {
        return {};
    }
    return fail(ErrorCode::WriteFailed, "the result cannot be written to stdout: {}",
                std::strerror(error));
}

ProgressDisplay::ProgressDisplay(ProgressStyle style) : style_(resolve(style)) {}

ProgressDisplay::~ProgressDisplay() {
    clear();
}

void ProgressDisplay::show(double fraction, std::string_view stage) {
    if (style_ == ProgressStyle::None) {
        return;
    }
    const std::lock_guard lock(mutex_);
    fraction_ = std::clamp(fraction, fraction_, 1.0);
    const auto now = Clock::now();
    if (stage == stage_ && now - shown_at_ < kRedrawInterval) {
        return;
    }
    shown_at_ = now;
    stage_ = stage;
    draw(fraction_, stage);
}

void ProgressDisplay::draw(double fraction, std::string_view stage) {
    if (style_ == ProgressStyle::Json) {
        const nlohmann::ordered_json line{{"progress", std::round(fraction * 1e4) / 1e4},
                                          {"stage", stage}};
        write_all(
            STDERR_FILENO,
            line.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + '\n');
        return;
    }
    const int filled = static_cast<int>(fraction * kBarWidth);
    const std::string bar(static_cast<std::size_t>(filled), '#');
    std::string line = shortened(
        fmt::format("[{:-<{}}] {:3.0f} %  {}", bar, kBarWidth, 100.0 * fraction, visible(stage)),
        static_cast<std::size_t>(std::max(1, terminal_width() - 1)));
    write_all(STDERR_FILENO, std::string(kEraseLine) + line);
    visible_ = true;
}

void ProgressDisplay::clear() {
    const std::lock_guard lock(mutex_);
    if (visible_) {
        write_all(STDERR_FILENO, kEraseLine);
        visible_ = false;
    }
}

void set_up_log(bool verbose) {
    auto logger = spdlog::stderr_logger_mt("suture");
    const bool terminal = isatty(STDERR_FILENO) != 0;
    auto formatter = std::make_unique<spdlog::pattern_formatter>();
    formatter->add_flag<VisiblePayload>('*').set_pattern(
        (terminal ? std::string(kEraseLine) : std::string()) + "%l: %*");
    logger->set_formatter(std::move(formatter));
    logger->set_level(verbose    ? spdlog::level::debug
                      : is_quiet ? spdlog::level::err
                                 : spdlog::level::warn);
    logger->flush_on(spdlog::level::debug);
    spdlog::set_default_logger(std::move(logger));
}

}  // namespace suture::cli

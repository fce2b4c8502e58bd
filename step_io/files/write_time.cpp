#include "files/write_time.h"

#include <fmt/chrono.h>

#include <charconv>
#include <cstdlib>
#include <string_view>

namespace suture::io {

namespace {

/// The last second of the year 9999: beyond, no format has room for the year.
constexpr std::time_t kLatest = 253402300799;

}  // namespace

Result<std::tm> time_of_writing() {
    std::time_t seconds = std::time(nullptr);
    if (const char* given = std::getenv("SOURCE_DATE_EPOCH")) {
        const std::string_view text(given);
        const auto [end, error] = std::from_chars(text.begin(), text.end(), seconds);
        if (error != std::errc() || end != text.end() || seconds < 0 || seconds > kLatest) {
            return fail(ErrorCode::Usage,
                        "SOURCE_DATE_EPOCH is \"{}\": it has to be a number of seconds since 1970, "
                        "at most {}",
                        text, kLatest);
        }
    }
    std::tm utc{};
    gmtime_r(&seconds, &utc);
    return utc;
}

std::string step_time(const std::tm& time) {
    return fmt::format("{:%Y-%m-%dT%H:%M:%S}", time);
}

std::string iges_time(const std::tm& time) {
    return fmt::format("{:%Y%m%d.%H%M%S}", time);
}

}  // namespace suture::io

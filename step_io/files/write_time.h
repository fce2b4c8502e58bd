#pragma once

#include "suture/base/result.h"

#include <ctime>
#include <string>

namespace suture::io {

/// When a file is written, in UTC: what the environment variable SOURCE_DATE_EPOCH says, in seconds
/// since 1970, else now. With it the same model gives the same bytes at any time.
/// Source: https://reproducible-builds.org/specs/source-date-epoch/
///
/// Refuses  (Usage) a variable that holds no such number, as its specification asks.
[[nodiscard]] Result<std::tm> time_of_writing();

/// As STEP writes it: 2024-02-29T12:30:00.
[[nodiscard]] std::string step_time(const std::tm& time);

/// As IGES 5.3 writes it: 20240229.123000.
[[nodiscard]] std::string iges_time(const std::tm& time);

}  // namespace suture::io

#pragma once

#include "cli/check_report.h"

#include <filesystem>
#include <string>

namespace suture::cli {

/// The edges of a check as a table for spreadsheets: RFC 4180, a head line, a line for each edge.
[[nodiscard]] std::string csv_of(const CheckResult& result);

/// The check as JUnit XML, as build servers read it: a test case for each edge and each knot line
/// inside a face. Near misses fail, what could not be measured is an error.
[[nodiscard]] std::string junit_of(const CheckResult& result, const std::filesystem::path& input);

}  // namespace suture::cli

#pragma once

#include "cli/command.h"

#include <string>

namespace suture::cli {

/// A report as one self-contained HTML page: the verdict and every section's whole table. Names
/// from files are escaped.
[[nodiscard]] std::string html_report(const Command& command, const Outcome& outcome);

}  // namespace suture::cli

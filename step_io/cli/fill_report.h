#pragma once

#include "cli/command.h"
#include "cli/fill_model.h"

namespace suture::cli {

/// What `fill` says of its work: exit code, verdict, tables and JSON document.
[[nodiscard]] Outcome report_fill(const FillSummary& summary, const FillSettings& settings);

}  // namespace suture::cli

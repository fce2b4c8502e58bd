#pragma once

#include "cli/command.h"
#include "cli/fill_model.h"

namespace suture::cli {

/// What `fill` says of its work: exit code, verdict, tables and JSON document.
[[nodiscard]] Outcome report_fill(const FillSummary& summary, const FillSettings& settings);

/// `holes` of the document, in the order of summary.holes.
[[nodiscard]] Json holes_of(const FillSummary& summary);

}  // namespace suture::cli

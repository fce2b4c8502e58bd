#pragma once

#include "cli/command.h"

#include <string>
#include <string_view>

namespace suture::cli {

/// A report as one self-contained HTML page: the verdict and every section's whole table. Names
/// from files are escaped.
///
/// Input  scene: what report::make_scene gives; then the page also shows the model in 3D, and the
///        edges in a table of its own instead of in that of their section.
[[nodiscard]] std::string html_report(const Command& command, const Outcome& outcome,
                                      std::string_view scene = {});

}  // namespace suture::cli

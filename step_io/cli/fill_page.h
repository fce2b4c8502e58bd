#pragma once

#include "cli/command.h"
#include "cli/fill_model.h"

#include <memory>

namespace suture::cli {

/// The scene of a fill's page (report::make_scene): the model before and after, and every edge of
/// the filled one in memory with its figures.
[[nodiscard]] Result<std::string> fill_scene(const FillSummary& summary, const Tolerance& tolerance,
                                             const Progress& progress);

/// Lets the HTML report of `fill` show this scene, measured when the report is asked for.
void add_fill_page(const Command& command, const std::shared_ptr<const FillSummary>& summary,
                   const Tolerance& tolerance, Outcome& outcome);

}  // namespace suture::cli

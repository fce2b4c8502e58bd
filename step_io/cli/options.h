#pragma once

#include "cli/command.h"
#include "cli/load.h"

#include <CLI/CLI.hpp>

namespace suture::cli {

/// A command of the app with the options that all commands have. Shown by --help: what it does
/// (`description`), then its options, then `examples`.
[[nodiscard]] std::shared_ptr<Command> add_command(CLI::App& app, const std::string& name,
                                                   const std::string& description,
                                                   const std::string& examples);

/// IN and --read-timeout
void add_input(Command& command);

/// --report R.json|R.html
void add_reports(Command& command);

/// --sew-tolerance MM and --no-sew
void add_sewing(Command& command, LoadOptions& options);
[[nodiscard]] Result<void> validate_sewing(const LoadOptions& options);

/// Refuses (Usage) common options that make no sense.
[[nodiscard]] Result<void> validate_common(const Command& command);

}  // namespace suture::cli

#pragma once

#include "suture/base/result.h"

#include <CLI/CLI.hpp>

#include <string>
#include <vector>

namespace suture::cli {

/// The command line's own definitions as other programs want them: man pages and the completions of
/// shells. Nothing of them is written by hand.
///
/// Input    what: "man" (the program), "man COMMAND", "bash", "zsh", "fish".
/// Refuses  (Usage) anything else.
[[nodiscard]] Result<std::string> describe(const CLI::App& app,
                                           const std::vector<std::string>& what);

}  // namespace suture::cli

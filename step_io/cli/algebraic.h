#pragma once

#include "cli/command.h"

namespace suture::cli {

/// The command for holes given by polynomials (docs/methods/algebraic.md).
[[nodiscard]] std::shared_ptr<Command> add_algebraic(CLI::App& app);

}  // namespace suture::cli

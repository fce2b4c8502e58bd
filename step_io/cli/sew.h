#pragma once

#include "cli/command.h"

namespace suture::cli {

[[nodiscard]] std::shared_ptr<Command> add_sew(CLI::App& app);

}  // namespace suture::cli

#pragma once

#include "cli/command.h"

namespace suture::cli {

/// suture patch MESH.obj: a smooth surface from a star-shaped control mesh.
[[nodiscard]] std::shared_ptr<Command> add_patch(CLI::App& app);

}  // namespace suture::cli

#pragma once

#include "cli/command.h"
#include "files/format.h"
#include "suture/check/validity.h"

#include <TopoDS_Shell.hxx>

#include <filesystem>

namespace suture::cli {

/// A shell that comes from no model, measured and written.
struct ShellOutput {
    double max_gap = 0.0;
    double max_angle = 0.0;
    Validity validity;
};

/// Measures a shell and writes it as a model of its own to the command's first output; progress
/// from `from` on. The part is named after the command's input.
[[nodiscard]] Result<ShellOutput> write_shell(Run& run, const Command& command,
                                              const TopoDS_Shell& shell, io::Format format,
                                              double from);

/// What the document says of it.
[[nodiscard]] Json json_of(const ShellOutput& output);

}  // namespace suture::cli

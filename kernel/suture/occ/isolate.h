#pragma once

#include "suture/base/progress.h"
#include "suture/base/result.h"

#include <chrono>
#include <functional>
#include <string>
#include <string_view>

namespace suture::occ {

/// Runs a program of ours, so that a crash or a hang of OCCT in there is an error here. It is
/// started, not forked: a process with several threads can do so at any time, from any of them.
///
/// Input    program: its path; request: what it reads from its standard input.
/// Result   the bytes that it answers by `serve`, or an Error (Internal) that begins with `what`:
///          "crashed (segmentation fault)", "gave no answer within 20 s", or what it refused.
[[nodiscard]] Result<std::string> run_isolated(std::string_view what, const std::string& program,
                                               const std::string& request,
                                               std::chrono::milliseconds limit,
                                               const Progress& progress);

/// What such a program does: reads the request, answers with what `action` makes of it. What OCCT
/// prints goes to standard error. Ends with the process that started it.
///
/// Result   the exit code.
int serve(std::string_view what,
          const std::function<Result<std::string>(const std::string& request)>& action);

}  // namespace suture::occ

#pragma once

#include "suture/base/progress.h"
#include "suture/base/result.h"

#include <chrono>
#include <functional>
#include <string>

namespace suture::occ {

/// Runs `action` in a child process, so that a crash or a hang of OCCT in there is an error here.
///
/// Input    action returns bytes; it sees all memory of this process as it is now, and what it
///          changes is gone afterwards.
/// Result   those bytes, or an Error (Internal) that begins with `what`: "crashed (segmentation
///          fault)", "gave no answer within 20 s", or what the action itself refused.
[[nodiscard]] Result<std::string> run_isolated(std::string_view what,
                                               const std::function<Result<std::string>()>& action,
                                               std::chrono::milliseconds limit,
                                               const Progress& progress);

}  // namespace suture::occ

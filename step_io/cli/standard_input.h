#pragma once

#include "suture/base/result.h"

namespace suture::cli {

/// Moves what is piped into the program to memory, so that this process and those that it starts
/// can read it more than once.
///
/// Refuses  (Usage) a terminal; (Unreadable) more than 4 GB, or what memory has no room for.
[[nodiscard]] Result<void> keep_standard_input();

}  // namespace suture::cli

#pragma once

#include "suture/base/result.h"

#include <filesystem>
#include <string_view>

namespace suture::io {

/// Whether a STEP file is all there, told from its text alone in one pass. OCCT reads half of a
/// file cut between two entities as if it were whole, and crashes on a reference to an entity that
/// is not there.
///
/// Refuses  (Unreadable) a file without data or without its end, and an entity that refers to
///          another which the file does not hold.
[[nodiscard]] Result<void> check_step_text(std::string_view text,
                                           const std::filesystem::path& file);

}  // namespace suture::io

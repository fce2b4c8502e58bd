#pragma once

#include "suture/base/result.h"

#include <filesystem>
#include <string_view>

namespace suture::io {

/// Whether an IGES file is all there: its last line states how many lines each section has.
///
/// Refuses  (Unreadable) a file without that line or with other numbers of lines.
[[nodiscard]] Result<void> check_iges_text(std::string_view text,
                                           const std::filesystem::path& file);

}  // namespace suture::io

#pragma once

#include "suture/base/result.h"

#include <filesystem>
#include <string>

namespace suture::io {

/// The bytes of a file, or only the first and the last `ends` of them, joined.
///
/// Refuses  (Unreadable) a missing file, a folder, a device, an empty file, no permission.
[[nodiscard]] Result<std::string> read_bytes(const std::filesystem::path& file);
[[nodiscard]] Result<std::string> read_ends(const std::filesystem::path& file, std::size_t ends);

}  // namespace suture::io

#pragma once

#include "suture/base/result.h"

#include <filesystem>
#include <limits>
#include <string>

namespace suture::io {

/// The name that stands for standard input; a file of that name is "./-".
inline constexpr const char* kStandardInput = "-";

/// A file's name as a user wants to read it.
[[nodiscard]] std::filesystem::path shown_name(const std::filesystem::path& file);

/// The bytes of a file, or only the first and the last `ends` of them, joined. Standard input is
/// read from its beginning where it is a file, and always whole.
///
/// Refuses  (Unreadable) a missing file, a folder, a device, an empty file, no permission; a file
///          of more than `most` bytes.
[[nodiscard]] Result<std::string> read_bytes(
    const std::filesystem::path& file, std::size_t most = std::numeric_limits<std::size_t>::max());
[[nodiscard]] Result<std::string> read_ends(const std::filesystem::path& file, std::size_t ends);

}  // namespace suture::io

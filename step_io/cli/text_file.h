#pragma once

#include "suture/base/result.h"

#include <filesystem>
#include <string_view>

namespace suture::cli {

/// Writes a whole text file or leaves the old one (see files/atomic_file.h).
[[nodiscard]] Result<void> write_text_file(const std::filesystem::path& file,
                                           std::string_view text);

/// Removes the temporaries of write_atomically that a killed process has left beside an output.
void remove_temporaries(const std::filesystem::path& output, int process);

}  // namespace suture::cli

#pragma once

#include "suture/base/result.h"

#include <filesystem>
#include <string>
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

/// The text of a STEP file as OCCT prints it, with UTF-8 in its strings, in ASCII as the standard
/// wants it: \X2\00E4\X0\ for letters beyond. Backslashes stay as they are: OCCT reads two as two.
[[nodiscard]] std::string encode_step_text(const std::string& text);

}  // namespace suture::io

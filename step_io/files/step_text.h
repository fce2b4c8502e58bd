#pragma once

#include "files/step_scan.h"
#include "suture/base/result.h"

#include <filesystem>
#include <optional>
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

/// OCCT's scanner has no room for a text of 16,384 characters, and takes memory with the square of
/// the length below that.
constexpr std::size_t kLongestStepText = 8000;

/// A STEP file whose long texts are cut.
struct ShorterStep {
    std::string text;
    int cut = 0;       ///< how many texts
    StepId first = 0;  ///< the entity that has the first of them
};

/// Cuts strings and binaries that are too long for OCCT to what is before their first escape, and
/// at most 100 characters. Nothing where there is no such text.
[[nodiscard]] std::optional<ShorterStep> with_short_texts(std::string_view text);

/// The text of a STEP file as OCCT prints it, with UTF-8 in its strings, in ASCII as the standard
/// wants it: \X2\00E4\X0\ for letters beyond. Backslashes stay as they are: OCCT reads two as two.
[[nodiscard]] std::string encode_step_text(const std::string& text);

}  // namespace suture::io

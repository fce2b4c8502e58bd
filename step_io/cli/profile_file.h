#pragma once

#include "suture/check/profile.h"

#include <filesystem>

namespace suture::cli {

/// A profile of one's own: a JSON object with `g0_mm`, `g1_deg`, `g2_percent`, and if wanted
/// `name`, `source`, `g2_by` ("larger" or "sum"), `g3_deg`, `sharp_deg`. docs/check.md has an
/// example.
///
/// Refuses  (Usage) a file that cannot be read, is no such object, or has a key that is none of
///          these: a misspelt limit must not pass in silence.
[[nodiscard]] Result<Profile> read_profile(const std::filesystem::path& file);

}  // namespace suture::cli

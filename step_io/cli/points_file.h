#pragma once

#include "suture/base/result.h"
#include "suture/base/through_point.h"

#include <filesystem>
#include <vector>

namespace suture::cli {

/// Reads points from a text file: x, y and z on a line, separated by commas, semicolons or blanks;
/// or these and the direction of the normal that is wanted there, six numbers.
/// Empty lines, lines that begin with #, and one line of column titles count for nothing.
///
/// Refuses  (Usage) a file that cannot be read, a line that is no point, naming it, a file without
///          a point.
[[nodiscard]] Result<std::vector<ThroughPoint>> read_points(const std::filesystem::path& file);

}  // namespace suture::cli

#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace suture::io {

/// What a file is that Suture does not read, and what to give it instead, as the end of a sentence:
/// "is a mesh (STL), ...". By its content, and where many formats look alike by its extension.
///
/// Input    ends: the file's first and last bytes, all of a short file.
/// Result   empty if the format is not known here.
[[nodiscard]] std::string describe_foreign(const std::filesystem::path& file,
                                           std::string_view ends);

}  // namespace suture::io

#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace suture {

/// The parts of a text between separators; one more than there are separators.
[[nodiscard]] std::vector<std::string_view> split(std::string_view text, char separator);

/// The text as it stands in XML and HTML, also within double quotes. Control characters, which XML
/// cannot hold however they are written, become '?'; tabs and line ends stay.
[[nodiscard]] std::string escape_markup(std::string_view text);

}  // namespace suture

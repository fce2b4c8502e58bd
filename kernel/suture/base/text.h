#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace suture {

/// The parts of a text between separators; one more than there are separators.
[[nodiscard]] std::vector<std::string_view> split(std::string_view text, char separator);

/// The text in UTF-8: every byte that is none becomes U+FFFD.
[[nodiscard]] std::string valid_utf8(std::string_view text);

/// The text as a terminal may be given it, in UTF-8: what would steer the terminal or turn the
/// direction of writing is written out, ESC as \x1B and U+202E as \u202E.
[[nodiscard]] std::string visible(std::string_view text);

/// At most so many letters of a text in UTF-8; what is left out of its middle becomes "...".
[[nodiscard]] std::string shortened(const std::string& text, std::size_t letters);

/// The text as it stands in XML and HTML, also within double quotes, in UTF-8. Control characters,
/// which XML cannot hold however they are written, become '?'; tabs and line ends stay.
[[nodiscard]] std::string escape_markup(std::string_view text);

}  // namespace suture

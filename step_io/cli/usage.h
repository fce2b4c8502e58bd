#pragma once

#include "suture/base/result.h"

#include <string>
#include <vector>

namespace suture::cli {

/// The command that the words are for: the first of them, if it is one; else "".
[[nodiscard]] std::string command_of(const std::vector<std::string>& words,
                                     const std::vector<std::string>& commands);

/// `help fill` is `fill --help`, as other programs have it.
[[nodiscard]] std::vector<std::string> without_help_command(std::vector<std::string> words);

/// Refuses (Usage) an empty word, and an option that ends in '='. Such a word comes from a script
/// whose variable is empty; the parser would take the option as not given, and --hole "" would fill
/// every hole.
[[nodiscard]] Result<void> expect_no_empty_word(const std::vector<std::string>& words);

/// What is wrong with words that the parser did not take, in terms of the user.
///
/// Input  options: the long options of the words' command; complaint: what the parser says.
[[nodiscard]] Error usage_error(const std::vector<std::string>& words,
                                const std::vector<std::string>& commands,
                                const std::vector<std::string>& options,
                                const std::string& complaint);

}  // namespace suture::cli

#include "cli/usage.h"

#include "cli/arguments.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace suture::cli {
namespace {

bool is_command(const std::string& word, const std::vector<std::string>& commands) {
    return std::ranges::find(commands, word) != commands.end();
}

std::string wrong_command(const std::string& word, const std::vector<std::string>& commands) {
    const std::vector<std::string_view> known(commands.begin(), commands.end());
    const std::optional<std::string_view> meant = nearest(word, known);
    return fmt::format("there is no command '{}'{}: the commands are {}; see suture --help", word,
                       meant ? fmt::format(", did you mean '{}'?", *meant) : "",
                       fmt::join(commands, ", "));
}

}  // namespace

std::string command_of(const std::vector<std::string>& words,
                       const std::vector<std::string>& commands) {
    return !words.empty() && is_command(words.front(), commands) ? words.front() : "";
}

std::vector<std::string> without_help_command(std::vector<std::string> words) {
    if (words.empty() || words.front() != "help") {
        return words;
    }
    words.erase(words.begin());
    words.emplace_back("--help");
    return words;
}

Result<void> expect_no_empty_word(const std::vector<std::string>& words) {
    for (std::size_t i = 0; i < words.size(); ++i) {
        const std::string& word = words[i];
        if (word.starts_with("--") && word.ends_with('=')) {
            return fail(ErrorCode::Usage, "{} has no value: give it one, or leave it out", word);
        }
        if (word.empty()) {
            return fail(ErrorCode::Usage,
                        "the word after '{}' is empty: give it a value, or leave "
                        "both out",
                        i == 0 ? "suture" : words[i - 1]);
        }
    }
    return {};
}

Error usage_error(const std::vector<std::string>& words, const std::vector<std::string>& commands,
                  const std::string& complaint) {
    if (words.empty()) {
        return {ErrorCode::Usage,
                fmt::format("say what to do: {}; see suture --help", fmt::join(commands, ", "))};
    }
    const std::string command = command_of(words, commands);
    if (!command.empty()) {
        return {ErrorCode::Usage, fmt::format("{}; see suture {} --help", complaint, command)};
    }
    if (!words.front().starts_with('-')) {
        return {ErrorCode::Usage, wrong_command(words.front(), commands)};
    }
    const auto later = std::ranges::find_if(
        words, [&](const std::string& word) { return is_command(word, commands); });
    return {ErrorCode::Usage,
            fmt::format("the command comes before its options: suture {} {}; see suture --help",
                        later == words.end() ? "COMMAND" : *later, words.front())};
}

}  // namespace suture::cli

#include "cli/usage.h"

#include "cli/arguments.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <optional>
#include <regex>

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

/// The first word that looks like an option and is none, with the one that is meant.
std::string wrong_option(const std::vector<std::string>& words,
                         const std::vector<std::string>& options) {
    const std::vector<std::string_view> known(options.begin(), options.end());
    for (const std::string& word : words) {
        const std::string name = word.substr(0, word.find('='));
        if (!name.starts_with("--") || name == "--" ||
            std::ranges::find(known, name) != known.end()) {
            continue;
        }
        const auto longer = std::ranges::find_if(
            known, [&](std::string_view option) { return option.starts_with(name); });
        const auto meant = longer != known.end() ? std::optional(*longer) : nearest(name, known);
        return fmt::format("there is no option {}{}", name,
                           meant ? fmt::format(", did you mean {}?", *meant) : "");
    }
    return {};
}

/// What the parser says, in the words of a user.
std::string plain(const std::string& complaint) {
    static const std::pair<std::regex, const char*> kSayings[] = {
        {std::regex("Could not convert: (\\S+) = (.*)"), "$1 takes a number, not '$2'"},
        {std::regex("(\\S+): 1 required \\S+ missing"), "$1 needs a value after it"},
        {std::regex("(\\S+): At Most 1 required but received (\\d+)"), "$1 is given $2 times"},
        {std::regex("IN is required"), "name the model to read"},
        {std::regex("OUT is required"), "name the file to write, after the model"},
        {std::regex("The following arguments? (?:was|were) not expected: (.*)"),
         "these words have no meaning here: $1"},
        {std::regex("--output is required"), "say with -o where to write: suture fill IN -o OUT"}};
    for (const auto& [pattern, saying] : kSayings) {
        if (std::smatch match; std::regex_match(complaint, match, pattern)) {
            return match.format(saying);
        }
    }
    return complaint;
}

/// `fill part.step out.step`, where the last word is no file yet: meant as the output.
std::string output_without_option(const std::vector<std::string>& words) {
    const bool has_output = std::ranges::any_of(words, [](const std::string& word) {
        return word.starts_with("-o") || word.starts_with("--output");
    });
    const std::string& last = words.back();
    constexpr std::size_t kLeast = 3;  // fill IN OUT
    if (has_output || words.size() < kLeast || last.starts_with('-') ||
        words[words.size() - 2].starts_with('-') || std::filesystem::exists(last)) {
        return {};
    }
    return fmt::format("the output is named with -o: suture {} {} -o {}", words.front(), words[1],
                       last);
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
                  const std::vector<std::string>& options, const std::string& complaint) {
    if (words.empty()) {
        return {ErrorCode::Usage,
                fmt::format("say what to do: {}; see suture --help", fmt::join(commands, ", "))};
    }
    const std::string command = command_of(words, commands);
    if (!command.empty()) {
        std::string said = wrong_option(words, options);
        if (said.empty() && std::ranges::find(options, "--output") != options.end()) {
            said = output_without_option(words);
        }
        if (said.empty()) {
            said = plain(complaint);
        }
        return {ErrorCode::Usage, fmt::format("{}; see suture {} --help", said, command)};
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

#include "cli/describe.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <sstream>

namespace suture::cli {
namespace {

using Commands = std::vector<const CLI::App*>;
using Options = std::vector<const CLI::Option*>;

/// The options of a command that begin with a dash.
Options options_of(const CLI::App& command) {
    Options options = command.get_options();
    std::erase_if(options, [](const CLI::Option* option) {
        return option->get_positional() ||
               (option->get_lnames().empty() && option->get_snames().empty());
    });
    return options;
}

std::vector<std::string> names_of(const CLI::Option& option) {
    std::vector<std::string> names;
    for (const std::string& name : option.get_snames()) {
        names.push_back("-" + name);
    }
    for (const std::string& name : option.get_lnames()) {
        names.push_back("--" + name);
    }
    return names;
}

bool takes_value(const CLI::Option& option) {
    return option.get_items_expected_max() > 0;
}

/// What stands for the value in the help: "MM", "auto|bar|json|none".
std::string value_of(const CLI::Option& option) {
    return option.get_option_text().empty() ? option.get_type_name() : option.get_option_text();
}

/// The words among which the value has to be, where the help says so: "default|tuned".
std::vector<std::string> choices_of(const CLI::Option& option) {
    std::vector<std::string> choices;
    std::istringstream words(value_of(option));
    for (std::string word; std::getline(words, word, '|');) {
        choices.push_back(word);
    }
    return choices.size() > 1 ? choices : std::vector<std::string>{};
}

std::string first_sentence(const std::string& text) {
    std::string line;
    std::istringstream words(text);
    for (std::string word; words >> word;) {
        line += (line.empty() ? "" : " ") + word;
    }
    return line;
}

/// Text for roff: no letter that it takes for its own.
std::string roff(std::string_view text) {
    std::string result;
    for (const char c : text) {
        if (c == '\\') {
            result += "\\e";
        } else if (c == '-') {
            result += "\\-";
        } else if ((c == '.' || c == '\'') && (result.empty() || result.back() == '\n')) {
            result += std::string("\\&") + c;
        } else {
            result += c;
        }
    }
    return result;
}

std::string man_options(const CLI::App& command) {
    std::string text;
    for (const CLI::Option* option : options_of(command)) {
        std::vector<std::string> names;
        for (const std::string& name : names_of(*option)) {
            names.push_back("\\fB" + roff(name) + "\\fR");
        }
        text += fmt::format(".TP\n{}{}\n{}\n", fmt::join(names, ", "),
                            takes_value(*option) ? " \\fI" + roff(value_of(*option)) + "\\fR" : "",
                            roff(first_sentence(option->get_description())));
    }
    return text;
}

std::string man_head(std::string_view name, const std::string& title) {
    std::string upper(name);
    std::ranges::transform(upper, upper.begin(), [](unsigned char c) { return std::toupper(c); });
    return fmt::format(".TH \"{}\" 1 \"\" \"Suture {}\" \"Suture\"\n.SH NAME\n{} \\- {}\n", upper,
                       SUTURE_VERSION, roff(name), roff(title));
}

/// The help's last part, as it stands.
std::string verbatim(const std::string& text) {
    return ".nf\n" + roff(text) + "\n.fi\n";
}

std::string man_of_program(const CLI::App& app, const Commands& commands) {
    std::istringstream about(app.get_description());
    std::string title;
    std::getline(about, title);
    std::string text = man_head("suture", title) +
                       ".SH SYNOPSIS\n\\fBsuture\\fR \\fICOMMAND\\fR ...\n.SH DESCRIPTION\n" +
                       roff(app.get_description()) + "\n.SH COMMANDS\n";
    for (const CLI::App* command : commands) {
        text += fmt::format(".TP\n\\fBsuture {0}\\fR\n{1}; see suture\\-{0}(1)\n",
                            roff(command->get_name()), roff(command->get_description()));
    }
    return text + ".SH OPTIONS\n" + man_options(app) + ".SH FIRST STEPS\n" +
           verbatim(app.get_footer());
}

std::string man_of_command(const CLI::App& command) {
    std::string usage;
    for (const CLI::Option* option : command.get_options()) {
        if (option->get_positional()) {
            usage += " \\fI" + option->get_name(true) + "\\fR";
        }
    }
    return man_head("suture-" + command.get_name(), command.get_description()) +
           fmt::format(".SH SYNOPSIS\n\\fBsuture {}\\fR{} [\\fIOPTIONS\\fR]\n", command.get_name(),
                       usage) +
           ".SH OPTIONS\n" + man_options(command) + ".SH DESCRIPTION\n" +
           verbatim(command.get_footer()) + ".SH SEE ALSO\nsuture(1)\n";
}

std::string names_of_commands(const Commands& commands) {
    std::vector<std::string> names;
    for (const CLI::App* command : commands) {
        names.push_back(command->get_name());
    }
    return fmt::format("{}", fmt::join(names, " "));
}

std::string bash(const Commands& commands) {
    std::string cases, values;
    for (const CLI::App* command : commands) {
        std::vector<std::string> words;
        for (const CLI::Option* option : options_of(*command)) {
            const std::vector<std::string> names = names_of(*option);
            words.insert(words.end(), names.begin(), names.end());
            const std::vector<std::string> choices = choices_of(*option);
            if (!choices.empty()) {
                values += fmt::format("        {}) words='{}' ;;\n", fmt::join(names, "|"),
                                      fmt::join(choices, " "));
            }
        }
        cases +=
            fmt::format("        {}) words='{}' ;;\n", command->get_name(), fmt::join(words, " "));
    }
    return fmt::format(R"(# Completion of suture for bash.
_suture() {{
    local word=${{COMP_WORDS[COMP_CWORD]}} before=${{COMP_WORDS[COMP_CWORD-1]}} words=
    COMPREPLY=()
    if [ "$COMP_CWORD" = 1 ]; then
        COMPREPLY=($(compgen -W '{} --help --version' -- "$word"))
        return
    fi
    case $before in
{}    esac
    if [ -z "$words" ]; then
        case $word in -*) ;; *) return ;; esac
        case ${{COMP_WORDS[1]}} in
{}        esac
    fi
    COMPREPLY=($(compgen -W "$words" -- "$word"))
}}
complete -o default -F _suture suture
)",
                       names_of_commands(commands), values, cases);
}

/// Text within single quotes of a shell, and where `brackets` end it, within those.
std::string quoted(const std::string& text, bool brackets = false) {
    std::string result;
    for (const char c : text) {
        if (c == '\'') {
            result += "'\\''";
        } else if (brackets && (c == '[' || c == ']' || c == ':')) {
            result += std::string("\\") + c;
        } else {
            result += c;
        }
    }
    return result;
}

std::string zsh(const Commands& commands) {
    std::string listed, cases;
    for (const CLI::App* command : commands) {
        listed += fmt::format("        '{}:{}'\n", command->get_name(),
                              quoted(command->get_description()));
        cases += fmt::format("    {}) _arguments \\\n", command->get_name());
        for (const CLI::Option* option : options_of(*command)) {
            for (const std::string& name : names_of(*option)) {
                const std::vector<std::string> choices = choices_of(*option);
                const std::string action =
                    choices.empty() ? "_files" : fmt::format("({})", fmt::join(choices, " "));
                cases += fmt::format("        '*{}[{}]{}' \\\n", name,
                                     quoted(first_sentence(option->get_description()), true),
                                     takes_value(*option) ? ":value:" + action : "");
            }
        }
        cases += "        '*:file:_files' ;;\n";
    }
    return fmt::format(R"(#compdef suture
local -a commands
if (( CURRENT == 2 )); then
    commands=(
{}    )
    _describe command commands
    return
fi
local name=$words[2]
shift words
(( CURRENT-- ))
case $name in
{}esac
)",
                       listed, cases);
}

std::string fish(const Commands& commands) {
    std::string text = "# Completion of suture for fish.\n";
    for (const CLI::App* command : commands) {
        text += fmt::format("complete -c suture -n __fish_use_subcommand -a {} -d '{}'\n",
                            command->get_name(), quoted(command->get_description()));
    }
    for (const CLI::App* command : commands) {
        for (const CLI::Option* option : options_of(*command)) {
            text += fmt::format("complete -c suture -n '__fish_seen_subcommand_from {}'",
                                command->get_name());
            for (const std::string& name : option->get_snames()) {
                text += " -s " + name;
            }
            for (const std::string& name : option->get_lnames()) {
                text += " -l " + name;
            }
            const std::vector<std::string> choices = choices_of(*option);
            if (!choices.empty()) {
                text += fmt::format(" -x -a '{}'", fmt::join(choices, " "));
            } else if (takes_value(*option)) {
                text += " -r";
            }
            text += fmt::format(" -d '{}'\n", quoted(first_sentence(option->get_description())));
        }
    }
    return text;
}

}  // namespace

Result<std::string> describe(const CLI::App& app, const std::vector<std::string>& what) {
    const Commands commands = app.get_subcommands({});
    if (what.size() == 2 && what[0] == "man") {
        for (const CLI::App* command : commands) {
            if (command->get_name() == what[1]) {
                return man_of_command(*command);
            }
        }
    } else if (what.size() == 1) {
        if (what[0] == "man") {
            return man_of_program(app, commands);
        }
        if (what[0] == "bash") {
            return bash(commands);
        }
        if (what[0] == "zsh") {
            return zsh(commands);
        }
        if (what[0] == "fish") {
            return fish(commands);
        }
        if (what[0] == "commands") {
            return names_of_commands(commands) + '\n';
        }
    }
    return fail(ErrorCode::Usage,
                "suture describe takes man, man COMMAND, commands, bash, zsh or fish");
}

}  // namespace suture::cli

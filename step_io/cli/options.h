#pragma once

#include "cli/command.h"
#include "cli/load.h"

#include <CLI/CLI.hpp>

namespace suture::cli {

/// CLI11's help, with long descriptions broken into lines.
class HelpFormatter : public CLI::Formatter {
  public:
    HelpFormatter();
    std::string make_option_desc(const CLI::Option* option) const override;
};

/// What the help of a command says.
struct CommandHelp {
    const char* title;        ///< one line, also in the list of commands
    const char* description;  ///< one paragraph
    const char* examples;     ///< lines, and the exit codes
};

/// A command of the app with the options that all commands have.
[[nodiscard]] std::shared_ptr<Command> add_command(CLI::App& app, const std::string& name,
                                                   const CommandHelp& help);

/// IN and --read-timeout
void add_input(Command& command);

/// --report R.json|R.html
void add_reports(Command& command);

/// --picture P.png, --view V, --shading S, --picture-size WxH, --no-edges
void add_picture(Command& command);

/// An option that takes a list, in one word or given several times: "1,2" of --hole 1 --hole 2.
CLI::Option* add_list(CLI::App& app, const std::string& names, std::string& list,
                      const std::string& description);

/// --sew-tolerance MM and --no-sew
void add_sewing(Command& command, LoadOptions& options);
[[nodiscard]] Result<void> validate_sewing(const LoadOptions& options);

/// The format that the output's ending asks for; the output becomes the command's only one.
[[nodiscard]] Result<io::Format> take_output(Command& command, const std::filesystem::path& output);

/// Refuses (Usage) common options that make no sense.
[[nodiscard]] Result<void> validate_common(const Command& command);

}  // namespace suture::cli

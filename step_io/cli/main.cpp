#include "cli/algebraic.h"
#include "cli/arguments.h"
#include "cli/batch.h"
#include "cli/command.h"
#include "cli/describe.h"
#include "cli/options.h"
#include "cli/patch.h"
#include "cli/picture_broker.h"
#include "cli/report_html.h"
#include "cli/report_json.h"
#include "cli/sew.h"
#include "cli/standard_input.h"
#include "cli/text_file.h"
#include "cli/usage.h"
#include "files/atomic_file.h"
#include "files/file_bytes.h"
#include "files/format.h"
#include "files/packed.h"
#include "files/read.h"
#include "suture/occ/guard.h"
#include "suture/platform/on_demand.h"
#include "suture/platform/sandbox.h"
#include "suture/platform/sanitized.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <spdlog/spdlog.h>
#include <sys/stat.h>
#include <unistd.h>

#include <Message.hxx>
#include <Message_Messenger.hxx>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <optional>
#include <sstream>
#include <tuple>

namespace suture::cli {
namespace {

constexpr const char* kAbout =
    "Suture closes the holes of a CAD model with smooth faces.\n"
    "It reads STEP, IGES and BREP, and writes these and meshes (STL, OFF, OBJ, 3MF, glTF).";

constexpr const char* kFooter =
    "First steps:\n"
    "  suture demo                                fill the bundled examples and look at the "
    "report\n"
    "  suture inspect part.step                   which holes are there?\n"
    "  suture fill part.step -o filled.step       fill them all\n"
    "  suture check filled.step                   how smooth did it get?\n"
    "Each command has its own help with examples: suture fill --help\n"
    "Exit codes: 0 done, 1 wrong usage, 2 unreadable input, 3 nothing to do, 4 done but out of\n"
    "tolerance or some hole refused, 5 internal error or output not written, 130/143 interrupted.";

Result<std::string> report_text(const Command& command, Run& run, const Outcome& outcome,
                                const std::string& extension) {
    const auto own = outcome.reports.find(extension);
    if (own != outcome.reports.end()) {
        return own->second(run);
    }
    return extension == ".html" ? html_report(command, outcome)
                                : to_text(whole_document(command, outcome));
}

Result<void> write_reports(const Command& command, Run& run, const Outcome& outcome) {
    for (const auto& report : command.common.reports) {
        const Result<std::string> text =
            report_text(command, run, outcome, report.extension().string());
        if (!text) {
            return tl::unexpected(text.error());
        }
        Result<void> written = write_text_file(report, *text);
        if (!written) {
            return written;
        }
    }
    return {};
}

Result<void> write_picture(const Command& command, Run& run, const Outcome& outcome,
                           const PictureBroker& broker) {
    if (command.common.picture.empty()) {
        return {};
    }
    const Result<std::string> page = report_text(command, run, outcome, ".html");
    if (!page) {
        return tl::unexpected(page.error());
    }
    const Progress progress = run.stage(Stage::Checking, "drawing the picture", 0.95, 1.0);
    return broker.take(*page, progress);
}

/// One line on stderr, and with --json the document that says the same.
int print_failure(const Command& command, const Error& error, int code,
                  const std::function<void(std::string_view)>& print) {
    print_error(error.message);
    if (command.common.json) {
        print(to_text(error_document(command, error, code)));
    }
    return code;
}

/// OCCT says what it likes; here it does only if asked.
void silence_occt(bool verbose) {
    if (!verbose) {
        Message::DefaultMessenger()->ChangePrinters().Clear();
    }
}

/// What ends here as an exception is a bug of ours: a line and an exit code all the same.
Result<Outcome> run_command(Command& command, Run& run, const PictureBroker& broker) {
    try {
        return occ::guarded("suture " + command.name, [&]() -> Result<Outcome> {
            silence_occt(command.common.verbose);
            Result<Outcome> result = command.run(run);
            if (!result) {
                return result;
            }
            const Result<void> written = write_reports(command, run, *result);
            if (!written) {
                return tl::unexpected(written.error());
            }
            const Result<void> drawn = write_picture(command, run, *result, broker);
            if (!drawn) {
                return tl::unexpected(drawn.error());
            }
            return result;
        });
    } catch (const ContractViolation& violation) {
        return fail(ErrorCode::Internal, "a bug in Suture, please report it: {}", violation.what());
    }
}

/// The exit code of a run that has come to its end: `code` if its result can be told.
int print_result(const ResultStream& out, std::string_view text, int code) {
    const Result<void> told = out.print(text);
    if (!told) {
        print_error(told.error().message);
        return exit_code(told.error().code);
    }
    return code;
}

/// A model without some of its parts is not what the file describes.
void lack(const std::vector<std::string>& parts, Outcome& outcome) {
    if (parts.empty()) {
        return;
    }
    outcome.verdict += fmt::format("; NOT whole: {} missing", fmt::join(parts, ", "));
    outcome.document["missing_parts"] = parts;
    if (outcome.exit_code == kDone || outcome.exit_code == kNothingToDo) {
        outcome.exit_code = kOutOfTolerance;
    }
}

SandboxPaths paths_of(const Command& command) {
    SandboxPaths paths;
    paths.read = command.more_inputs;
    if (command.input != io::kStandardInput) {
        paths.read.push_back(io::followed(command.input).parent_path());
        paths.read.push_back(command.input.has_parent_path() ? command.input.parent_path() : ".");
    }
    std::error_code ignored;
    paths.write.push_back(std::filesystem::temp_directory_path(ignored));
    for (const auto* files : {&command.outputs, &command.common.reports}) {
        for (const std::filesystem::path& file : *files) {
            paths.write.push_back(io::followed(file).parent_path());
        }
    }
    try {
        paths.execute.emplace_back(program_on_demand("suture_occt_filling"));
        paths.execute.emplace_back(program_on_demand("suture_grow"));
        paths.read.push_back(paths.execute.back().parent_path());  // our modules, which come late
    } catch (const std::runtime_error&) {
        // Method occt says so when it is asked for.
    }
    return paths;
}

/// The job: in the supervised process.
int run_job(Command& command, const StageLine& line, std::stop_token cancel,
            const PictureBroker& broker) {
    if (!command.input.empty()) {  // the other commands read nothing of a user's
        enter_sandbox(paths_of(command));
    }
    const ResultStream out(command.common.verbose);
    if (command.common.quiet) {
        be_quiet();
        command.common.progress = ProgressStyle::None;
    }
    set_up_log(command.common.verbose);
    Run run(line, std::move(cancel), command.common.progress);
    Result<Outcome> outcome = run_command(command, run, broker);
    run.display().clear();
    if (!outcome && outcome.error().code == ErrorCode::Cancelled) {
        return kInterrupted;  // the supervisor knows why, and says it
    }
    if (outcome) {
        lack(run.missing_parts(), *outcome);
    }
    if (!outcome) {
        return print_failure(command, outcome.error(), exit_code(outcome.error().code),
                             [&](std::string_view text) { std::ignore = out.print(text); });
    }
    const CommonOptions& common = command.common;
    return print_result(out,
                        common.json    ? to_text(whole_document(command, *outcome))
                        : common.quiet ? ""
                                       : text_of(*outcome, common.verbose),
                        outcome->exit_code);
}

/// Which file stands in the output's place, and since when; nothing where there is none.
std::string identity_of_output(const Command& command) {
    struct stat file {};
    if (!command.one_output || stat(command.outputs.front().c_str(), &file) != 0) {
        return "";
    }
    return fmt::format("{} {} {}.{}", file.st_dev, file.st_ino, file.st_mtim.tv_sec,
                       file.st_mtim.tv_nsec);
}

/// Whether the output is there although the run did not come to its end.
std::string what_is_written(const Command& command, const std::string& before) {
    if (!command.one_output) {
        return "";
    }
    return identity_of_output(command) == before
               ? "; nothing was written"
               : fmt::format("; {} is written", command.outputs.front().string());
}

constexpr double kGigabyte = 1e9;

double gigabytes(std::uint64_t bytes) {
    return static_cast<double>(bytes) / kGigabyte;
}

/// Bytes.
std::uint64_t memory_limit(const Command& command) {
    const std::optional<double>& given = command.common.memory;
    return given ? static_cast<std::uint64_t>(*given * kGigabyte) : default_memory_limit();
}

/// What is said of a job that did not end by itself.
Error error_of(const Command& command, const Ending& ending, const std::string& written) {
    const std::string file =
        command.input.empty() ? "demo" : io::shown_name(command.input).string();
    const bool reading = ending.stage == Stage::Reading;
    switch (ending.kind) {
        case Ending::Kind::Crashed:
            if (reading) {
                return {ErrorCode::Unreadable,
                        fmt::format("{}: OCCT's reader crashed ({}) while {}: the file is damaged, "
                                    "or hits a bug in OCCT",
                                    file, strsignal(ending.code), ending.what)};
            }
            return {ErrorCode::Internal,
                    fmt::format("{}: the program crashed ({}) while {}{}", file,
                                strsignal(ending.code), ending.what, written)};
        case Ending::Kind::Killed:
            return {ErrorCode::Internal,
                    fmt::format("{}: the system ended the program (SIGKILL) while {}, as a rule "
                                "because memory ran out: --memory sets a limit{}",
                                file, ending.what, written)};
        case Ending::Kind::OutOfMemory:
            return {reading ? ErrorCode::Unreadable : ErrorCode::Internal,
                    fmt::format("{}: {:.3g} GB of memory are not enough for {}; --memory gives "
                                "more{}",
                                file, gigabytes(memory_limit(command)), ending.what, written)};
        case Ending::Kind::Timeout:
            return {ErrorCode::Internal,
                    fmt::format("{}: stopped after {:g} s while {}; --timeout gives more time{}",
                                file, command.common.timeout, ending.what, written)};
        case Ending::Kind::ReadTimeout:
            return {ErrorCode::Unreadable,
                    fmt::format("{}: reading took longer than {:g} s; give it more time with "
                                "--read-timeout if the file is large",
                                file, command.common.read_timeout)};
        case Ending::Kind::NotStarted:
            return {ErrorCode::Internal,
                    fmt::format("the system gives no new process: {}", std::strerror(ending.code))};
        case Ending::Kind::Interrupted:
        case Ending::Kind::Exited:
            break;
    }
    return {ErrorCode::Cancelled, fmt::format("interrupted while {}{}", ending.what, written)};
}

/// Of STEP files OCCT can read some that it crashes on when it keeps the names of faces. What a
/// packed file holds is not looked for in this process, which has no sandbox.
bool may_be_step(const std::filesystem::path& file) {
    constexpr std::size_t kEnds = 4096;
    const Result<std::string> bytes = io::read_ends(file, kEnds);
    if (!bytes || io::is_packed(*bytes)) {
        return bytes.has_value();
    }
    const Result<io::Format> format = io::format_of_bytes(*bytes, file);
    return format && *format == io::Format::Step;
}

void print_to_stdout(std::string_view text) {
    [[maybe_unused]] const ssize_t written = write(STDOUT_FILENO, text.data(), text.size());
}

std::chrono::milliseconds milliseconds(double seconds) {
    return std::chrono::milliseconds(static_cast<std::int64_t>(std::ceil(1000.0 * seconds)));
}

int supervised(Command& command) {
    if (command.input == io::kStandardInput) {
        if (const Result<void> kept = keep_standard_input(); !kept) {
            return print_failure(command, kept.error(), exit_code(kept.error().code),
                                 print_to_stdout);
        }
    }
    const JobLimits limits{milliseconds(command.common.read_timeout),
                           milliseconds(command.common.timeout), memory_limit(command)};
    const PictureBroker broker(command);
    const auto job = [&](const StageLine& line, std::stop_token cancel) {
        return run_job(command, line, std::move(cancel), broker);
    };
    if (!command.common.external_references) {
        io::close_external_references();
    }
    const std::string output_before = identity_of_output(command);
    Ending ending = supervise(limits, job);
    if (ending.kind == Ending::Kind::Crashed && ending.stage == Stage::Reading &&
        may_be_step(command.input)) {
        io::forget_face_names();
        ending = supervise(limits, job);
    }
    if (ending.kind == Ending::Kind::Exited) {
        return ending.code;
    }
    for (const auto& output : command.outputs) {
        remove_temporaries(output, ending.process);
    }
    for (const auto& report : command.common.reports) {
        remove_temporaries(report, ending.process);
    }
    const Error error = error_of(command, ending, what_is_written(command, output_before));
    constexpr int kSignalBase = 128;  // as shells have it
    const int code = ending.kind == Ending::Kind::Interrupted ? kSignalBase + ending.code
                                                              : exit_code(error.code);
    return print_failure(command, error, code, print_to_stdout);
}

/// One line of error, and with --json a document, for words that no command could take.
int print_usage_error(const std::vector<std::string>& words,
                      const std::vector<std::string>& commands, const Error& error) {
    Command meant;
    meant.name = command_of(words, commands);
    meant.common.json = std::ranges::find(words, "--json") != words.end();
    return print_failure(meant, error, kUsage, print_to_stdout);
}

/// The long options of the command that the words are for.
std::vector<std::string> options_of(const CLI::App& app, const std::vector<std::string>& words) {
    std::vector<std::string> names;
    for (const CLI::App* command : app.get_subcommands([&](const CLI::App* other) {
             return !words.empty() && other->get_name() == words.front();
         })) {
        for (const CLI::Option* option : command->get_options()) {
            for (const std::string& name : option->get_lnames()) {
                names.push_back("--" + name);
            }
        }
    }
    return names;
}

/// The exit code if the run ends here.
std::optional<int> parse(CLI::App& app, const std::vector<std::string>& given) {
    const std::vector<std::string> words = without_help_command(given);
    std::vector<std::string> commands;
    for (const CLI::App* command : app.get_subcommands({})) {
        commands.push_back(command->get_name());
    }
    if (const Result<void> full = expect_no_empty_word(words); !full) {
        return print_usage_error(words, commands, full.error());
    }
    try {
        std::vector<std::string> reversed = join_number_lists(words);
        std::reverse(reversed.begin(), reversed.end());  // as CLI11 wants them
        app.parse(std::move(reversed));
    } catch (const CLI::ParseError& error) {
        if (error.get_exit_code() == static_cast<int>(CLI::ExitCodes::Success)) {
            std::ostringstream text;
            app.exit(error, text);  // --help, --version
            return print_result(ResultStream(false), text.str(), kDone);
        }
        return print_usage_error(
            words, commands, usage_error(words, commands, options_of(app, words), error.what()));
    }
    return std::nullopt;
}

/// The many files that a command line is about, if it is.
Result<std::optional<Batch>> batch_of(const CLI::App& app, const std::vector<std::string>& words) {
    const std::vector<const CLI::App*> commands = app.get_subcommands({});
    const auto command = std::ranges::find_if(commands, [&](const CLI::App* one) {
        return !words.empty() && one->get_name() == words.front();
    });
    if (command == commands.end()) {
        return std::nullopt;
    }
    Result<std::optional<Batch>> batch = parse_batch(**command, join_number_lists(words));
    if (batch && *batch && !(*batch)->folder.empty()) {
        const std::filesystem::path folder = (*batch)->items.front().document.parent_path();
        std::error_code error;
        std::filesystem::create_directories(folder, error);
        if (error) {
            return fail(ErrorCode::Usage, "--out-dir {}: {}", folder.string(), error.message());
        }
    }
    return batch;
}

/// --version -v: what a service wants to know of this machine too.
std::optional<std::string> long_version(std::vector<std::string> words) {
    std::ranges::sort(words);
    const bool wanted = words == std::vector<std::string>{"--version", "-v"} ||
                        words == std::vector<std::string>{"--verbose", "--version"};
    if (!wanted) {
        return std::nullopt;
    }
    const std::string memory = kSanitized
                                   ? "none, with a sanitizer"
                                   : fmt::format("{:.3g} GB", gigabytes(default_memory_limit()));
    return fmt::format("suture {}\nsandbox: {}\nmemory limit: {}\n", SUTURE_VERSION,
                       sandbox_support(), memory);
}

int run_program(std::vector<std::string> words) {
    if (const auto version = long_version(words)) {
        return print_result(ResultStream(false), *version, kDone);
    }
    CLI::App app(kAbout, "suture");
    app.set_version_flag("--version", "suture " SUTURE_VERSION);
    app.footer(kFooter);
    app.require_subcommand(1);
    app.formatter(std::make_shared<HelpFormatter>());  // the commands inherit it
    const std::vector<std::shared_ptr<Command>> commands{
        add_inspect(app), add_fill(app),  add_bridge(app),  add_check(app), add_convert(app),
        add_sew(app),     add_patch(app), add_methods(app), add_demo(app),  add_algebraic(app)};
    if (words.empty()) {
        return print_result(ResultStream(false), app.help(), kUsage);
    }
    if (!words.empty() && words.front() == "describe") {  // for packages, so not in the help
        const Result<std::string> text = describe(app, {words.begin() + 1, words.end()});
        return text ? print_result(ResultStream(false), *text, kDone)
                    : print_usage_error(words, {}, text.error());
    }
    const Result<std::optional<Batch>> batch = batch_of(app, words);
    if (!batch) {
        return print_usage_error(words, {words.front()}, batch.error());
    }
    if (*batch) {
        words = (*batch)->items.front().words;  // what is wrong with one is so with all
    }
    if (const std::optional<int> ended = parse(app, words)) {
        return *ended;
    }
    for (const auto& command : commands) {
        if (!command->app->parsed()) {
            continue;
        }
        Result<void> valid = command->validate();
        if (valid) {
            valid = validate_common(*command);
        }
        if (!valid) {
            return print_failure(*command, valid.error(), kUsage, print_to_stdout);
        }
        return *batch ? run_batch(**batch) : supervised(*command);
    }
    return kUsage;
}

}  // namespace
}  // namespace suture::cli

namespace {

/// A file that is opened later must not take the place of stdout or stderr.
void open_missing_streams() {
    for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
        if (fcntl(stream, F_GETFD) < 0) {
            std::ignore = open("/dev/null", O_RDWR);  // takes the lowest number that is free
        }
    }
}

}  // namespace

int main(int argc, char** argv) {
    open_missing_streams();
    const std::vector<std::string> words(argv + std::min(1, argc), argv + argc);
    return suture::cli::run_program(words);
}

#include "cli/sew.h"

#include "cli/arguments.h"
#include "cli/load.h"
#include "cli/options.h"
#include "cli/report_json.h"
#include "files/write.h"
#include "suture/check/validity.h"

#include <fmt/format.h>

namespace suture::cli {
namespace {

constexpr CommandHelp kHelp{
    "Sew what lies on each other",
    "Make one edge of edges that lie on each other: of loose faces, of shells that touch, of the "
    "two "
    "sides of a crack. What is connected then is one shell, and a solid where it closes. Parts of "
    "an "
    "assembly and closed bodies that touch stay apart; thin walls, slots and other features stay "
    "as "
    "they are.",
    "  suture sew wing.igs -o wing.step                    at a tolerance from the model\n"
    "  suture sew halves.step -o body.step --sew-tolerance 0.05\n"
    "Exit codes: 0 done, 3 there is nothing to sew (nothing is written), 4 written, but not "
    "valid,\n"
    "2 the file cannot be read, 1 wrong usage, 5 the output cannot be written.\n"};

struct SewOptions {
    std::filesystem::path output;
    LoadOptions load;
    bool force = false;
    io::Format format = io::Format::Step;
};

Result<void> validate(Command& command, SewOptions& options) {
    const Result<io::Format> format = take_output(command, options.output);
    if (!format) {
        return tl::unexpected(format.error());
    }
    options.format = *format;
    for (const auto& result :
         {validate_sewing(options.load),
          expect_writable("--output", options.output, command.input, force_of(options.force))}) {
        if (!result) {
            return result;
        }
    }
    return {};
}

std::string body_text(const Validity& validity) {
    std::string text =
        validity.solids > 0 ? counted(validity.solids, "solid") : counted(validity.shells, "shell");
    text += validity.closed ? ", closed"
                            : fmt::format(", open ({})", counted(validity.free_edges, "free edge"));
    return text + (validity.valid ? ", valid" : ", NOT valid");
}

Result<Outcome> sew(Run& run, const Command& command, const SewOptions& options) {
    constexpr double kLoaded = 0.6;
    constexpr double kWritten = 0.8;
    const Result<LoadedModel> model = load_model(run, command.input, options.load, kLoaded);
    if (!model) {
        return tl::unexpected(model.error());
    }
    std::vector<std::string> notes = notes_of(model->sewing);
    if (!model->sewing.changed) {
        return fail(ErrorCode::NothingToDo, "there is nothing to sew in {}{}",
                    command.input.string(), notes.empty() ? "" : "; " + notes.front());
    }
    const Stopwatch writing;
    std::ignore = run.stage(Stage::Writing, "writing " + options.output.filename().string(),
                            kLoaded, kWritten);
    const auto written = io::write_model(model->file, options.output, options.format, {});
    if (!written) {
        return tl::unexpected(written.error());
    }
    const double seconds_write = writing.seconds();
    const Stopwatch checking;
    std::ignore = run.stage(Stage::Checking, "checking the result", kWritten, 1.0);
    const Validity validity = measure_validity(model->whole);
    Outcome outcome;
    outcome.exit_code = validity.valid ? kDone : kOutOfTolerance;
    outcome.verdict = fmt::format("{}, widest gap {} mm; {}", text_of(model->sewing),
                                  short_number(model->sewing.largest_gap), body_text(validity));
    outcome.document = {{"output", options.output.string()},
                        {"output_format", io::to_string(options.format)},
                        {"model", json_of(model->file)},
                        {"sewing", json_of(model->sewing)},
                        {"validity", json_of(validity)},
                        {"notes", notes},
                        {"seconds",
                         {{"read", model->seconds_read},
                          {"sew", model->seconds_sew},
                          {"write", seconds_write},
                          {"check", checking.seconds()}}}};
    if (!notes.empty()) {
        outcome.sections.push_back({"Notes", Table({}), std::move(notes)});
    }
    return outcome;
}

}  // namespace

std::shared_ptr<Command> add_sew(CLI::App& app) {
    auto command = add_command(app, "sew", kHelp);
    auto options = std::make_shared<SewOptions>();
    add_input(*command);
    CLI::App& sub = *command->app;
    sub.add_option("-o,--output", options->output, "The file to write: .step .iges .brep")
        ->required()
        ->option_text("OUT");
    sub.add_option("--sew-tolerance", options->load.sew_tolerance,
                   "Sew edges that lie closer than this (default: from the model)")
        ->option_text("MM");
    add_reports(*command);
    sub.add_flag("--force", options->force, "Allow OUT to be IN itself");
    Command* self = command.get();
    command->validate = [options, self] { return validate(*self, *options); };
    command->run = [options, self](Run& run) { return sew(run, *self, *options); };
    return command;
}

}  // namespace suture::cli

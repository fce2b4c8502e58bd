#include "cli/options.h"

#include "cli/arguments.h"

#include "report/scene.h"
#include <fmt/ranges.h>

#include <algorithm>
#include <regex>
#include <sstream>

namespace suture::cli {
namespace {

constexpr std::size_t kHelpWidth = 100;
constexpr std::size_t kOptionColumn = 34;

const std::map<std::string, ProgressStyle> kStyles{{"auto", ProgressStyle::Auto},
                                                   {"none", ProgressStyle::None},
                                                   {"bar", ProgressStyle::Bar},
                                                   {"json", ProgressStyle::Json}};

/// Breaks a text into lines of at most `width` letters, between words.
std::string wrapped(const std::string& text, std::size_t width) {
    std::string result;
    std::size_t line = 0;
    std::istringstream words(text);
    for (std::string word; words >> word;) {
        if (line > 0 && line + 1 + word.size() > width) {
            result += '\n';
            line = 0;
        } else if (line > 0) {
            result += ' ';
            ++line;
        }
        result += word;
        line += word.size();
    }
    return result;
}

}  // namespace

HelpFormatter::HelpFormatter() {
    column_width(kOptionColumn);
}

std::string HelpFormatter::make_option_desc(const CLI::Option* option) const {
    return wrapped(option->get_description(), kHelpWidth - kOptionColumn);
}

std::shared_ptr<Command> add_command(CLI::App& app, const std::string& name,
                                     const CommandHelp& help) {
    auto command = std::make_shared<Command>();
    command->name = name;
    command->app = app.add_subcommand(name, help.title);
    command->app->footer(wrapped(help.description, kHelpWidth) + "\n\nExamples:\n" + help.examples);
    CommonOptions& common = command->common;
    command->app->add_flag("--json", common.json,
                           "Print one JSON document on stdout, and nothing else there");
    command->app
        ->add_option_function<std::string>(
            "--progress",
            [&common](const std::string& style) { common.progress = kStyles.at(style); },
            "How to show progress on stderr: auto (a bar on a terminal), bar, json (a line "
            "of JSON per step) or none")
        ->check(CLI::IsMember({"auto", "bar", "json", "none"}))
        ->option_text("STYLE");
    command->app->add_flag("-v,--verbose", common.verbose,
                           "Print all there is to say, and on stderr what is being done, OCCT's "
                           "own messages included");
    command->app
        ->add_flag("-q,--quiet", common.quiet,
                   "Print errors alone, and with --json the document; the exit code says the rest")
        ->excludes("--verbose");
    command->app
        ->add_option("--timeout", common.timeout,
                     "Give up the whole run after so many seconds (default 7200)")
        ->option_text("SECONDS");
    command->app
        ->add_option("--memory", common.memory,
                     "Give up where more memory is needed (default: three quarters of the "
                     "machine's)")
        ->option_text("GB");
    command->validate = [] { return Result<void>(); };
    return command;
}

void add_input(Command& command) {
    command.app
        ->add_option(
            "IN", command.input,
            "The model: STEP, IGES, BREP or FCStd, packed ones too, told by its content; - is "
            "standard input")
        ->required()
        ->option_text(" ");
    command.app
        ->add_option("--read-timeout", command.common.read_timeout,
                     "Give up reading a file after so many seconds (default 300)")
        ->option_text("SECONDS");
    command.app
        ->add_option_function<std::string>(
            "--external-references",
            [&follow = command.common.external_references](const std::string& word) {
                follow = word == "yes";
            },
            "Whether to read the other STEP files that the model names as its parts, where they "
            "stand in its folder or below: yes (default) or no")
        ->check(CLI::IsMember({"yes", "no"}))
        ->option_text("yes|no");
}

void add_reports(Command& command) {
    command.app
        ->add_option(
            "--report", command.common.reports,
            fmt::format("Write the report to a file too, as its ending says: {}; can be given "
                        "more than once",
                        fmt::join(command.common.report_endings, ", ")))
        ->option_text("FILE")
        ->expected(1)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
}

void add_picture(Command& command) {
    CommonOptions& common = command.common;
    report::PictureWish& wish = common.picture_wish;
    command.app
        ->add_option("--picture", common.picture,
                     "Write a picture of the model: its edges by class, and the faces as --shading "
                     "says (drawn by a headless browser)")
        ->option_text("P.png");
    command.app
        ->add_option("--view", wish.view,
                     "From where: iso, front, back, left, right, top, bottom, worst, edge12, or a "
                     "direction x,y,z")
        ->option_text("VIEW");
    command.app
        ->add_option("--shading", wish.shading, "shaded, zebra (stripes) or curvature (a map)")
        ->check(CLI::IsMember({"shaded", "zebra", "curvature"}))
        ->option_text("KIND");
    command.app
        ->add_option_function<std::string>(
            "--picture-size",
            [&wish](const std::string& text) {
                char x = 0;
                std::istringstream stream(text);
                constexpr int kMost = 8192;
                if (!(stream >> wish.width >> x >> wish.height) || x != 'x' || !stream.eof() ||
                    wish.width < 16 || wish.height < 16 || wish.width > kMost ||
                    wish.height > kMost) {
                    throw CLI::ValidationError("--picture-size",
                                               "give it as 1600x1000, not " + text);
                }
            },
            "Pixels of the picture (default 1600x1000)")
        ->option_text("WxH");
    command.app->add_flag_callback(
        "--picture-without-edges", [&wish] { wish.edges = false; }, "Draw the faces alone");
}

namespace {

Result<void> validate_picture(const Command& command) {
    const CommonOptions& common = command.common;
    if (common.picture.empty()) {
        return {};
    }
    if (report::viewer_script().empty()) {
        return fail(ErrorCode::Usage,
                    "--picture: this program was built without (SUTURE_REPORT=OFF)");
    }
    if (common.picture.extension() != ".png") {
        return fail(ErrorCode::Usage, "--picture {}: give it the ending .png",
                    common.picture.string());
    }
    static const std::regex known(
        "iso|front|back|left|right|top|bottom|worst|edge[0-9]+|"
        "-?[0-9.]+,-?[0-9.]+,-?[0-9.]+");
    if (!std::regex_match(common.picture_wish.view, known)) {
        return fail(ErrorCode::Usage,
                    "--view {}: it is iso, front, back, left, right, top, bottom, worst, edge and "
                    "a number, or a direction x,y,z",
                    common.picture_wish.view);
    }
    if (const auto browser = report::find_browser(); !browser) {
        return fail(ErrorCode::Usage, "--picture: {}", browser.error().message);
    }
    return expect_writable("--picture", common.picture, command.input, Force::NotOffered);
}

}  // namespace

CLI::Option* add_list(CLI::App& app, const std::string& names, std::string& list,
                      const std::string& description) {
    const auto take = [&list](const std::vector<std::string>& words) {
        list = fmt::format("{}", fmt::join(words, ","));
    };
    return app.add_option_function<std::vector<std::string>>(names, take, description)
        ->expected(1)
        ->allow_extra_args(false)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
}

void add_sewing(Command& command, LoadOptions& options) {
    command.app
        ->add_option("--sew-tolerance", options.sew_tolerance,
                     "Sew edges that lie closer than this (default: from the model)")
        ->option_text("MM");
    command.app->add_flag_callback(
        "--no-sew", [&options] { options.sew = false; }, "Leave faces and shells as they are");
}

Result<void> validate_sewing(const LoadOptions& options) {
    if (options.sew_tolerance) {
        return expect_positive("--sew-tolerance", *options.sew_tolerance);
    }
    return {};
}

Result<io::Format> take_output(Command& command, const std::filesystem::path& output) {
    command.outputs = {output};
    command.one_output = true;
    return io::format_of_extension(output);
}

Result<void> validate_common(const Command& command) {
    constexpr double kLongest = 1e8;  // seconds: three years, and no overflow anywhere
    const std::initializer_list<std::pair<const char*, double>> limits = {
        {"--read-timeout", command.common.read_timeout},
        {"--timeout", command.common.timeout},
        {"--memory", command.common.memory.value_or(1.0)}};
    for (const auto& [option, value] : limits) {
        if (Result<void> positive = expect_positive(option, value); !positive) {
            return positive;
        }
        if (value > kLongest) {
            return fail(ErrorCode::Usage, "{} is at most {:g}, not {:g}", option, kLongest, value);
        }
    }
    if (Result<void> picture = validate_picture(command); !picture) {
        return picture;
    }
    for (const auto& report : command.common.reports) {
        const auto extension = report.extension();
        const auto& endings = command.common.report_endings;
        if (std::ranges::find(endings, extension.string()) == endings.end()) {
            return fail(ErrorCode::Usage, "--report {}: give it one of the endings {}",
                        report.string(), fmt::join(endings, ", "));
        }
        auto writable = expect_writable("--report", report, command.input, Force::NotOffered);
        if (!writable) {
            return writable;
        }
        for (const auto& output : command.outputs) {
            if (output.lexically_normal() == report.lexically_normal()) {
                return fail(ErrorCode::Usage, "--report {} is the output itself: name another file",
                            report.string());
            }
        }
    }
    return {};
}

}  // namespace suture::cli

#include "cli/arguments.h"
#include "cli/fill_model.h"
#include "cli/fill_page.h"
#include "cli/fill_report.h"
#include "cli/methods.h"
#include "cli/options.h"
#include "cli/report_html.h"
#include "cli/report_json.h"
#include "cli/text_file.h"
#include "suture/platform/process.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <system_error>

namespace suture::cli {
namespace {

namespace fs = std::filesystem;

constexpr CommandHelp kHelp{
    "Fill the bundled examples with every method",
    "Fill the bundled examples with every method that applies, write the results as STEP files, a "
    "report to look at in a browser, and a table. Nothing needs to be prepared.",
    "  suture demo                  writes into the folder suture-demo\n"
    "  suture demo --out /tmp/demo  somewhere else\n"
    "Exit codes: 0 done, 4 `auto` left a hole open or out of tolerance, 1 wrong usage.\n"};

struct DemoOptions {
    fs::path out = "suture-demo";
};

/// The examples of an installed program lie beside it, those of a build in the source tree.
Result<std::vector<fs::path>> find_examples() {
    std::error_code error;
    const fs::path program = fs::read_symlink(kOwnProgram, error);
    const fs::path installed = program.parent_path().parent_path() / SUTURE_INSTALLED_EXAMPLES;
    for (const fs::path& folder : {installed, fs::path(SUTURE_SOURCE_EXAMPLES)}) {
        std::vector<fs::path> files;
        for (const auto& entry : fs::directory_iterator(folder, error)) {
            if (entry.path().extension() == ".step") {
                files.push_back(entry.path());
            }
        }
        if (!files.empty()) {
            std::sort(files.begin(), files.end());
            return files;
        }
    }
    return fail(ErrorCode::Unreadable, "the examples are neither in {} nor in {}",
                installed.string(), SUTURE_SOURCE_EXAMPLES);
}

/// The table and the document of all fills.
class DemoReport {
  public:
    /// scene: of the fill's page; empty if nothing is filled
    void add(const fs::path& example, std::string_view method, const fs::path& output,
             const FillSummary& summary, const std::string& scene) {
        const Json holes = holes_of(summary);
        for (std::size_t i = 0; i < summary.holes.size(); ++i) {
            const HoleReport& hole = summary.holes[i];
            if (hole.status == FillStatus::Skipped) {
                continue;
            }
            const bool filled = hole.status == FillStatus::Filled;
            add_row(example, method, hole, summary.sides[i], filled);
            add_picture(example, method, hole, scene);
            Json entry{{"example", example.filename().string()},
                       {"output", filled ? Json(output.string()) : Json()},
                       {"closed", summary.validity.closed},
                       {"valid", summary.validity.valid}};
            entry.update(holes[i]);
            fills_.push_back(std::move(entry));
            const bool good = filled && hole.verdict.within() && summary.validity.valid;
            complete_ = complete_ && (good || method != "auto");
        }
    }

    [[nodiscard]] Outcome outcome(const fs::path& out, double seconds) && {
        Outcome outcome;
        outcome.exit_code = complete_ ? kDone : kOutOfTolerance;
        outcome.verdict =
            fmt::format("{} written in {:.1f} s; open {} in a browser",
                        counted(files_, "STEP file"), seconds, (out / "report.html").string());
        Section section{"", std::move(table_), {}};
        section.brief = std::move(best_);
        outcome.sections.push_back(std::move(section));
        outcome.document = {{"output", out.string()},
                            {"fills", std::move(fills_)},
                            {"seconds", {{"total", seconds}}}};
        return outcome;
    }

    void count_file() { ++files_; }

    [[nodiscard]] const std::vector<GalleryItem>& pictures() const { return pictures_; }

  private:
    void add_picture(const fs::path& example, std::string_view method, const HoleReport& hole,
                     const std::string& scene) {
        GalleryItem item;
        item.group = example.stem().string();
        item.name = method;
        item.good = hole.status == FillStatus::Filled && hole.verdict.within();
        item.caption =
            hole.status == FillStatus::Filled
                ? fmt::format("{}{}, gap {} mm, angle {}°, {}: {} s",
                              method == "auto" ? hole.method_used + ", " : "",
                              to_string(hole.continuity_reached), short_number(hole.max_gap),
                              short_number(degrees(hole.max_angle)),
                              to_string(hole.verdict.severity), fmt::format("{:.2f}", hole.seconds))
                : hole.reason;
        item.scene = hole.status == FillStatus::Filled ? scene : "";
        pictures_.push_back(std::move(item));
    }

    void add_row(const fs::path& example, std::string_view method, const HoleReport& hole,
                 int sides, bool filled) {
        const std::string result =
            filled ? std::string(to_string(hole.verdict.severity)) : "refused: " + hole.reason;
        const std::string used =
            method == "auto" && filled ? "auto: " + hole.method_used : std::string(method);
        const auto cell = [&](std::string text) { return filled ? std::move(text) : ""; };
        std::vector<std::string> row{example.stem().string(),
                                     std::to_string(sides),
                                     used,
                                     cell(std::string(to_string(hole.continuity_reached))),
                                     cell(short_number(hole.max_gap)),
                                     cell(short_number(degrees(hole.max_angle))),
                                     fmt::format("{:.2f}", hole.seconds),
                                     result};
        if (method == "auto") {
            best_.add(row);
        }
        table_.add(std::move(row));
    }

    Table table_{
        {"example", ">sides", "method", "reached", ">gap [mm]", ">angle [deg]", ">s", "result"}};
    Table best_{table_};  ///< what `auto` made: a screen has no room for all
    std::vector<GalleryItem> pictures_;
    Json fills_ = Json::array();
    int files_ = 0;
    bool complete_ = true;
};

bool anything_filled(const FillSummary& summary) {
    return std::any_of(summary.holes.begin(), summary.holes.end(),
                       [](const HoleReport& hole) { return hole.status == FillStatus::Filled; });
}

Result<void> fill_example(Run& run, const fs::path& example, std::string_view method,
                          const fs::path& out, DemoReport& report) {
    FillSettings settings;
    settings.input = example;
    settings.output = out / fmt::format("{}.{}.step", example.stem().string(), method);
    settings.request.method = method;
    const Result<FillSummary> summary = fill_model(run, settings);
    if (!summary) {
        return tl::unexpected(summary.error());
    }
    std::string scene;
    if (anything_filled(*summary)) {
        Result<std::string> drawn = fill_scene(*summary, settings.request.tolerance, {});
        if (!drawn) {
            return tl::unexpected(drawn.error());
        }
        scene = std::move(*drawn);
    }
    report.add(example, method, settings.output, *summary, scene);
    if (!scene.empty()) {
        report.count_file();
    } else {
        std::error_code ignored;
        fs::remove(settings.output, ignored);  // a method that does not apply leaves no file
    }
    return {};
}

Result<Outcome> demo(Run& run, const Command& command, const fs::path& out) {
    const Stopwatch watch;
    const Result<std::vector<fs::path>> examples = find_examples();
    if (!examples) {
        return tl::unexpected(examples.error());
    }
    const std::vector<MethodRow> methods = method_rows();
    DemoReport report;
    const double share = 1.0 / static_cast<double>(examples->size() * methods.size());
    double from = 0.0;
    for (const fs::path& example : *examples) {
        for (const MethodRow& method : methods) {
            run.window(from, from + share);
            from += share;
            const Result<void> filled = fill_example(run, example, method.id, out, report);
            if (!filled) {
                return tl::unexpected(filled.error());
            }
        }
    }
    const std::vector<GalleryItem> pictures = report.pictures();
    Outcome outcome = std::move(report).outcome(out, watch.seconds());
    const std::pair<const char*, std::string> files[] = {
        {"report.html", gallery_report(command, outcome, pictures)},
        {"report.json", to_text(whole_document(command, outcome))}};
    for (const auto& [name, text] : files) {
        const Result<void> written = write_text_file(out / name, text);
        if (!written) {
            return tl::unexpected(written.error());
        }
    }
    return outcome;
}

Result<void> validate(Command& command, const fs::path& out) {
    std::error_code error;
    fs::create_directories(out, error);
    if (error) {
        return fail(ErrorCode::Usage, "--out {}: the folder cannot be made: {}", out.string(),
                    error.message());
    }
    // A stopped run leaves its temporaries beside this one.
    command.outputs = {out / "report.html"};
    return expect_writable("--out", command.outputs.front(), {}, Force::NotOffered);
}

}  // namespace

std::shared_ptr<Command> add_demo(CLI::App& app) {
    auto command = add_command(app, "demo", kHelp);
    auto options = std::make_shared<DemoOptions>();
    command->app->add_option("-o,--out", options->out, "Folder for the results, made if need be")
        ->option_text("DIR");
    Command* self = command.get();
    command->validate = [options, self] { return validate(*self, options->out); };
    command->run = [options, self](Run& run) { return demo(run, *self, options->out); };
    return command;
}

}  // namespace suture::cli

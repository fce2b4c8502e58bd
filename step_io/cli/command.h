#pragma once

#include "cli/console.h"
#include "cli/exit_code.h"
#include "cli/supervise.h"
#include "cli/table.h"
#include "suture/base/progress.h"
#include "suture/base/result.h"

#include "report/picture.h"
#include <nlohmann/json.hpp>

#include <array>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

namespace CLI {  // NOLINT: the library's name
class App;
}

namespace suture::cli {

using Json = nlohmann::ordered_json;

class Run;

/// A part of a report: shown on the terminal, where it has to fit a screen unless --verbose asks
/// for all of it, and in full in an HTML report.
struct Section {
    std::string heading;
    Table table;
    std::vector<std::string> notes;
    bool of_edges = false;  ///< a page with a 3D view has a better table of the same
    bool detail = false;    ///< the terminal shows it with --verbose only
    bool notes_are_detail = false;
    std::optional<Table> brief = std::nullopt;  ///< of the table, what a screen has room for
};

/// What a command has to say. The terminal, the JSON document and the HTML report all show it.
struct Outcome {
    int exit_code = kDone;
    std::string verdict;  ///< one line
    std::string next;     ///< one line: what to do about it; may be empty
    std::vector<Section> sections;
    Json document = Json::object();  ///< without the head that all documents share
    /// Reports in formats that only this command has, or has its own way for, by extension
    /// (".csv"): made only if asked for.
    std::map<std::string, std::function<Result<std::string>(Run&)>> reports;
};

/// The outcome for a terminal: its tables, what to do next, and the verdict as the last line.
[[nodiscard]] std::string text_of(const Outcome& outcome, bool verbose);

/// What a command's run needs of the program around it.
class Run {
  public:
    Run(const StageLine& line, std::stop_token cancel, ProgressStyle style)
        : line_(line), cancel_(std::move(cancel)), display_(style) {}

    /// Enters a stage and gives the progress that its work reports to.
    ///
    /// Input  from, to: what the stage covers of the whole run, in [0,1].
    [[nodiscard]] Progress stage(Stage stage, std::string what, double from, double to);

    /// Lets the stages to come cover only a part of the run: for runs that repeat their stages.
    void window(double from, double to) { window_ = {from, to}; }

    [[nodiscard]] ProgressDisplay& display() { return display_; }

    /// Parts of the model that lie in other files and could not be read.
    void lack(std::vector<std::string> parts) { missing_parts_ = std::move(parts); }
    [[nodiscard]] const std::vector<std::string>& missing_parts() const { return missing_parts_; }

  private:
    StageLine line_;
    std::stop_token cancel_;
    ProgressDisplay display_;
    std::array<double, 2> window_ = {0.0, 1.0};
    std::vector<std::string> missing_parts_;
};

/// Options that every command has.
struct CommonOptions {
    bool json = false;
    bool verbose = false;
    bool quiet = false;  ///< errors alone
    ProgressStyle progress = ProgressStyle::Auto;
    double read_timeout = 300.0;   ///< seconds
    double timeout = 7200.0;       ///< seconds, for the whole run
    std::optional<double> memory;  ///< GB; none: from the machine
    bool external_references = true;
    std::vector<std::filesystem::path> reports;
    std::vector<std::string> report_endings = {".html", ".json"};
    std::filesystem::path picture;  ///< of the model, drawn from the HTML report
    report::PictureWish picture_wish;
};

/// One command of the program. `validate` finds what is wrong with the command line itself, before
/// anything is read; `run` does the work, in the supervised process.
struct Command {
    std::string name;
    CLI::App* app = nullptr;
    CommonOptions common;
    std::filesystem::path input;
    std::vector<std::filesystem::path> more_inputs;  ///< known after validate
    std::vector<std::filesystem::path> outputs;      ///< known after validate
    bool one_output = false;  ///< outputs has just the file that the user asked for
    std::function<Result<void>()> validate;
    std::function<Result<Outcome>(Run&)> run;
};

[[nodiscard]] std::shared_ptr<Command> add_inspect(CLI::App& app);
[[nodiscard]] std::shared_ptr<Command> add_fill(CLI::App& app);
[[nodiscard]] std::shared_ptr<Command> add_bridge(CLI::App& app);
[[nodiscard]] std::shared_ptr<Command> add_check(CLI::App& app);
[[nodiscard]] std::shared_ptr<Command> add_convert(CLI::App& app);
[[nodiscard]] std::shared_ptr<Command> add_methods(CLI::App& app);
[[nodiscard]] std::shared_ptr<Command> add_demo(CLI::App& app);

/// Seconds since the construction.
class Stopwatch {
  public:
    [[nodiscard]] double seconds() const {
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
    }

  private:
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace suture::cli

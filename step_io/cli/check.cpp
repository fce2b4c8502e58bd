#include "cli/arguments.h"
#include "cli/batch.h"
#include "cli/check_report.h"
#include "cli/options.h"
#include "cli/profile_file.h"

#include <fmt/format.h>

#include <optional>

namespace suture::cli {
namespace {

constexpr CommandHelp kHelp{
    "Measure how smoothly the faces of a model meet",
    "Measure how smoothly the faces of a model meet: for every edge between two faces the gap, the "
    "angle between the two normals, and the curvature mismatch. An edge passes if its faces meet "
    "within the gap of the profile and if they are either tangent within its angle or clearly "
    "sharp; what lies between is a near miss. Loose faces (IGES) are sewn first, in memory.",
    "  suture check part.step                          every edge, against CATIA's limits\n"
    "  suture check part.step --edges 12,15-17         these edges only\n"
    "  suture check part.step --g1 0.1 --report r.html\n"
    "  suture check part.step --profile alias --report edges.csv --report junit.xml\n"
    "Exit codes: 0 all edges pass, 4 some are near misses, 2 the file cannot be read, 1 wrong "
    "usage.\n"};

struct CheckOptions {
    LoadOptions load;
    std::string profile_name = Profile{}.name;
    std::optional<double> g0, g1, g2, g3, sharp;
    std::string edge_list;
    std::vector<int> edges;
    bool certify = false;
    double slack = 5.0;  ///< percent
    Profile profile;
};

Result<void> take_limit(std::string_view option, const std::optional<double>& given, double factor,
                        double& limit) {
    if (!given) {
        return {};
    }
    limit = *given * factor;
    return expect_positive(option, *given);
}

bool is_file(const std::filesystem::path& profile) {
    return profile.extension() == ".json";
}

Result<void> choose_profile(CheckOptions& options) {
    const Result<Profile> named = is_file(options.profile_name)
                                      ? read_profile(options.profile_name)
                                      : find_profile(options.profile_name);
    if (!named) {
        return tl::unexpected(named.error());
    }
    Profile& profile = options.profile;
    profile = *named;
    constexpr double kDegree = kPi / 180.0;
    for (const auto& result : {take_limit("--g0", options.g0, 1.0, profile.tolerance.linear),
                               take_limit("--g1", options.g1, kDegree, profile.tolerance.angular),
                               take_limit("--g2", options.g2, 0.01, profile.tolerance.curvature),
                               take_limit("--g3", options.g3, kDegree, profile.g3),
                               take_limit("--sharp", options.sharp, kDegree, profile.sharp)}) {
        if (!result) {
            return result;
        }
    }
    return {};
}

Result<void> validate(Command& command, CheckOptions& options) {
    if (is_file(options.profile_name)) {
        command.more_inputs = {options.profile_name};
    }
    if (!options.edge_list.empty()) {
        Result<std::vector<int>> edges = parse_edges(options.edge_list);
        if (!edges) {
            return tl::unexpected(edges.error());
        }
        options.edges = std::move(*edges);
    }
    if (auto slack = expect_positive("--slack", options.slack); !slack) {
        return slack;
    }
    if (!is_file(options.profile_name)) {
        if (auto profile = choose_profile(options); !profile) {
            return profile;
        }
    }
    return validate_sewing(options.load);
}

Result<Outcome> check(Run& run, const Command& command, const CheckOptions& options) {
    constexpr double kLoaded = 0.4;
    constexpr double kMeasured = 0.6;
    constexpr double kProven = 0.9;
    const auto result = std::make_shared<CheckResult>();
    Result<LoadedModel> model = load_model(run, command.input, options.load, kLoaded);
    if (!model) {
        return tl::unexpected(model.error());
    }
    result->model = std::move(*model);
    result->profile = options.profile;
    const TopoDS_Shape& shape = result->model.whole;
    const Stopwatch watch;
    const Progress progress = run.stage(Stage::Checking, "measuring edges", kLoaded, kMeasured);
    Result<ContinuityReport> report =
        measure_continuity(shape, options.profile, options.edges, progress);
    if (!report) {
        return tl::unexpected(report.error());
    }
    result->report = std::move(*report);
    if (options.edges.empty()) {
        Result<std::vector<KnotLine>> knots = measure_face_knots(shape, progress);
        if (!knots) {
            return tl::unexpected(knots.error());
        }
        result->knots = std::move(*knots);
    }
    if (options.certify) {
        const Progress proving = run.stage(Stage::Checking, "certifying edges", kMeasured, kProven);
        result->slack = 0.01 * options.slack;
        Result<std::vector<EdgeCertificate>> certificates =
            certify_edges(shape, result->report.edges, options.profile, result->slack, proving);
        if (!certificates) {
            return tl::unexpected(certificates.error());
        }
        result->certificates = std::move(*certificates);
    }
    result->validity = measure_validity(shape);
    result->seconds = watch.seconds();
    result->summary = summarise(result->report, result->knots, result->profile);
    return report_check(command, result);
}

}  // namespace

std::shared_ptr<Command> add_check(CLI::App& app) {
    auto command = add_command(app, "check", kHelp);
    auto options = std::make_shared<CheckOptions>();
    add_input(*command);
    std::string names = "Limits by name:";
    for (const Profile& profile : profiles()) {
        names += fmt::format(" {} ({} mm, {:.3g} deg, {:.3g} %);", profile.name,
                             profile.tolerance.linear, degrees(profile.tolerance.angular),
                             100.0 * profile.tolerance.curvature);
    }
    names += " or a file of your own, limits.json";
    CLI::App& sub = *command->app;
    sub.add_option("--profile", options->profile_name, names)->option_text("NAME");
    sub.add_option("--g0", options->g0, "Largest gap between two faces")->option_text("MM");
    sub.add_option("--g1", options->g1, "Largest angle of a tangent edge")->option_text("DEG");
    sub.add_option("--g2", options->g2, "Largest curvature mismatch of a G2 edge")
        ->option_text("PERCENT");
    sub.add_option("--g3", options->g3, "Largest G3 mismatch of a G3 edge")->option_text("DEG");
    sub.add_option("--sharp", options->sharp,
                   "From this angle on an edge is meant to be sharp (default 5)")
        ->option_text("DEG");
    add_list(sub, "--edges,--edge", options->edge_list, "Measure these edges only: 12,15-17")
        ->option_text("E...");
    sub.add_flag("--certify", options->certify,
                 "Prove upper bounds of gap and angle along every edge, besides measuring them");
    sub.add_option("--slack", options->slack,
                   "How far a proven bound may lie above what was measured (default 5)")
        ->option_text("PERCENT");
    add_sewing(*command, options->load);
    command->common.report_endings = {".html", ".json", ".csv", ".xml"};
    add_reports(*command);
    add_picture(*command);
    add_batch_options(*command->app, false);
    Command* self = command.get();
    command->validate = [options, self] { return validate(*self, *options); };
    command->run = [options, self](Run& run) -> Result<Outcome> {
        if (is_file(options->profile_name)) {
            if (auto profile = choose_profile(*options); !profile) {
                return tl::unexpected(profile.error());
            }
        }
        return check(run, *self, *options);
    };
    return command;
}

}  // namespace suture::cli

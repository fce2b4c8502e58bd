#include "cli/arguments.h"
#include "cli/load.h"
#include "cli/options.h"
#include "cli/report_json.h"
#include "suture/check/continuity.h"
#include "suture/check/validity.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
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
    "Exit codes: 0 all edges pass, 4 some are near misses, 2 the file cannot be read, 1 wrong "
    "usage.\n"};

struct CheckOptions {
    LoadOptions load;
    std::string profile_name = Profile{}.name;
    std::optional<double> g0, g1, g2, sharp;
    std::string edge_list;
    std::vector<int> edges;
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

Result<void> choose_profile(CheckOptions& options) {
    const Result<Profile> named = find_profile(options.profile_name);
    if (!named) {
        return tl::unexpected(named.error());
    }
    Profile& profile = options.profile;
    profile = *named;
    constexpr double kDegree = kPi / 180.0;
    for (const auto& result : {take_limit("--g0", options.g0, 1.0, profile.tolerance.linear),
                               take_limit("--g1", options.g1, kDegree, profile.tolerance.angular),
                               take_limit("--g2", options.g2, 0.01, profile.tolerance.curvature),
                               take_limit("--sharp", options.sharp, kDegree, profile.sharp)}) {
        if (!result) {
            return result;
        }
    }
    return {};
}

Result<void> validate(CheckOptions& options) {
    if (!options.edge_list.empty()) {
        Result<std::vector<int>> edges = parse_edges(options.edge_list);
        if (!edges) {
            return tl::unexpected(edges.error());
        }
        options.edges = std::move(*edges);
    }
    const Result<void> profile = choose_profile(options);
    return profile ? validate_sewing(options.load) : profile;
}

/// Neither sharp nor within tolerance.
bool near_miss(const EdgeContinuity& edge, const Profile& profile) {
    return edge.max_gap > profile.tolerance.linear ||
           (edge.edge_class != EdgeClass::Sharp && edge.max_angle > profile.tolerance.angular);
}

Section edge_section(std::vector<EdgeContinuity> edges, const Profile& profile) {
    // Near misses first, then whatever is smooth, the worst on top; sharp edges are meant to be.
    const auto rank = [&](const EdgeContinuity& edge) {
        const int group =
            near_miss(edge, profile) ? 0 : (edge.edge_class == EdgeClass::Sharp ? 2 : 1);
        return std::tuple(group, -edge.max_angle, -edge.max_gap);
    };
    std::stable_sort(edges.begin(), edges.end(),
                     [&](const auto& a, const auto& b) { return rank(a) < rank(b); });
    Table table(
        {">edge", "faces", "class", ">gap [mm]", ">angle [deg]", ">curvature [%]", "at", "remark"});
    for (const EdgeContinuity& edge : edges) {
        const auto& at = edge.max_gap > profile.tolerance.linear ? edge.gap_at : edge.angle_at;
        table.add({std::to_string(edge.edge), fmt::format("{}, {}", edge.faces[0], edge.faces[1]),
                   std::string(to_string(edge.edge_class)), short_number(edge.max_gap),
                   short_number(degrees(edge.max_angle)),
                   short_number(100.0 * edge.curvature_mismatch),
                   fmt::format("{:.6g} {:.6g} {:.6g}", at.x(), at.y(), at.z()),
                   near_miss(edge, profile) ? "near miss " + edge.note : edge.note});
    }
    return {"Edges, the worst first", std::move(table), {}};
}

struct Summary {
    int edges = 0, sharp = 0, g0 = 0, g1 = 0, g2 = 0, near_misses = 0, unmeasured = 0;
    double max_gap = 0.0, max_angle = 0.0;  ///< of the edges that are not sharp
};

Summary summarise(const ContinuityReport& report, const Profile& profile) {
    Summary summary;
    for (const EdgeContinuity& edge : report.edges) {
        ++summary.edges;
        const std::array<int*, 4> counters{&summary.sharp, &summary.g0, &summary.g1, &summary.g2};
        ++*counters[static_cast<std::size_t>(edge.edge_class)];
        summary.near_misses += near_miss(edge, profile) ? 1 : 0;
        summary.unmeasured += edge.samples > 0 ? 0 : 1;
        summary.max_gap = std::max(summary.max_gap, edge.max_gap);
        if (edge.edge_class != EdgeClass::Sharp) {
            summary.max_angle = std::max(summary.max_angle, edge.max_angle);
        }
    }
    return summary;
}

Json summary_json(const Summary& summary, const ContinuityReport& report) {
    return {{"edges", summary.edges},
            {"sharp", summary.sharp},
            {"G0", summary.g0},
            {"G1", summary.g1},
            {"G2", summary.g2},
            {"near_misses", summary.near_misses},
            {"unmeasured", summary.unmeasured},
            {"max_gap", summary.max_gap},
            {"max_angle_deg", degrees(summary.max_angle)},
            {"free_edges", report.free_edges},
            {"non_manifold_edges", report.non_manifold}};
}

std::string verdict_of(const Summary& summary, const Profile& profile) {
    const std::string limits = fmt::format("{} mm, {} deg", short_number(profile.tolerance.linear),
                                           short_number(degrees(profile.tolerance.angular)));
    std::string kinds = fmt::format("{} G2, {} G1, {} G0, {} sharp", summary.g2, summary.g1,
                                    summary.g0, summary.sharp);
    if (summary.unmeasured > 0) {
        kinds += fmt::format("; {} could not be measured", counted(summary.unmeasured, "edge"));
    }
    if (summary.near_misses == 0 && summary.unmeasured == 0) {
        return fmt::format("all of {} pass ({}): {}", counted(summary.edges, "edge"), limits,
                           kinds);
    }
    return fmt::format("{} of {} near misses, neither sharp nor within {}: {}", summary.near_misses,
                       counted(summary.edges, "edge"), limits, kinds);
}

Section shape_section(const Validity& validity, const ContinuityReport& report) {
    Section section{"Shape",
                    Table({">solids", ">shells", ">faces", "closed", "valid", ">free edges",
                           ">largest tolerance [mm]"}),
                    validity.problems};
    section.table.add({std::to_string(validity.solids), std::to_string(validity.shells),
                       std::to_string(validity.faces), validity.closed ? "yes" : "no",
                       validity.valid ? "yes" : "no", std::to_string(report.free_edges.size()),
                       short_number(validity.max_tolerance)});
    return section;
}

Result<Outcome> check(Run& run, const Command& command, const CheckOptions& options) {
    constexpr double kLoaded = 0.4;
    const Result<LoadedModel> model = load_model(run, command.input, options.load, kLoaded);
    if (!model) {
        return tl::unexpected(model.error());
    }
    const Stopwatch watch;
    const Progress progress = run.stage(Stage::Checking, "measuring edges", kLoaded, 1.0);
    const Result<ContinuityReport> report =
        measure_continuity(model->whole, options.profile, options.edges, progress);
    if (!report) {
        return tl::unexpected(report.error());
    }
    const Validity validity = measure_validity(model->whole);
    const Summary summary = summarise(*report, options.profile);
    Outcome outcome;
    outcome.exit_code = summary.near_misses + summary.unmeasured > 0 ? kOutOfTolerance : kDone;
    outcome.verdict = verdict_of(summary, options.profile);
    Json edges = Json::array();
    for (const EdgeContinuity& edge : report->edges) {
        Json entry = json_of(edge);
        entry["near_miss"] = near_miss(edge, options.profile);
        edges.push_back(std::move(entry));
    }
    outcome.document = {
        {"model", json_of(model->file)},
        {"sewing", json_of(model->sewing)},
        {"profile", json_of(options.profile)},
        {"edges", std::move(edges)},
        {"summary", summary_json(summary, *report)},
        {"shape", json_of(validity)},
        {"seconds",
         {{"read", model->seconds_read}, {"sew", model->seconds_sew}, {"check", watch.seconds()}}}};
    outcome.sections.push_back(edge_section(report->edges, options.profile));
    outcome.sections.push_back(shape_section(validity, *report));
    return outcome;
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
    names.back() = '.';
    CLI::App& sub = *command->app;
    sub.add_option("--profile", options->profile_name, names)->option_text("NAME");
    sub.add_option("--g0", options->g0, "Largest gap between two faces")->option_text("MM");
    sub.add_option("--g1", options->g1, "Largest angle of a tangent edge")->option_text("DEG");
    sub.add_option("--g2", options->g2, "Largest curvature mismatch of a G2 edge")
        ->option_text("PERCENT");
    sub.add_option("--sharp", options->sharp,
                   "From this angle on an edge is meant to be sharp (default 5)")
        ->option_text("DEG");
    sub.add_option("--edges,--edge", options->edge_list, "Measure these edges only: 12,15-17")
        ->option_text("E...");
    add_sewing(*command, options->load);
    add_reports(*command);
    command->validate = [options] { return validate(*options); };
    const Command* self = command.get();
    command->run = [options, self](Run& run) { return check(run, *self, *options); };
    return command;
}

}  // namespace suture::cli

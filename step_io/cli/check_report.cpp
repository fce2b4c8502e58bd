#include "cli/check_report.h"

#include "cli/check_exports.h"
#include "cli/report_html.h"
#include "cli/report_json.h"
#include "cli/scene_parts.h"

#include "report/profile_json.h"
#include "report/scene.h"
#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace suture::cli {
namespace {

std::string percent_of(double mismatch) {
    return short_number(100.0 * mismatch);
}

std::string point_text(const Eigen::Vector3d& at) {
    return fmt::format("{:.6g} {:.6g} {:.6g}", at.x(), at.y(), at.z());
}

/// What fits a screen: the edges that do not pass.
Table faulty_edges(const CheckResult& result) {
    Table table({">edge", "faces", ">gap [mm]", ">angle [deg]", "at", "near miss"});
    for (const EdgeContinuity& edge : worst_first(result.report.edges, result.profile)) {
        if (edge.samples > 0 && !is_near_miss(edge, result.profile)) {
            continue;
        }
        const bool gaps = edge.max_gap > result.profile.tolerance.linear;
        const std::string fault = fault_of(edge, result.profile);
        table.add({std::to_string(edge.edge), fmt::format("{}, {}", edge.faces[0], edge.faces[1]),
                   short_number(edge.max_gap), short_number(degrees(edge.max_angle)),
                   point_text(gaps ? edge.gap_at : edge.angle_at),
                   fault.empty() ? edge.note : fault});
    }
    return table;
}

Section edge_section(const CheckResult& result) {
    const Profile& profile = result.profile;
    Table table({">edge", "faces", "class", ">gap [mm]", ">angle [deg]", ">curvature [%]",
                 ">G3 [deg]", "at", "remark"});
    for (const EdgeContinuity& edge : worst_first(result.report.edges, profile)) {
        const auto& at = edge.max_gap > profile.tolerance.linear ? edge.gap_at : edge.angle_at;
        const double mismatch = profile.curvature_by == CurvatureMeasure::Larger
                                    ? edge.curvature_mismatch
                                    : edge.curvature_mismatch_sum;
        table.add({std::to_string(edge.edge), fmt::format("{}, {}", edge.faces[0], edge.faces[1]),
                   std::string(to_string(edge.edge_class)), short_number(edge.max_gap),
                   short_number(degrees(edge.max_angle)), percent_of(mismatch),
                   edge.g3_samples > 0 ? short_number(degrees(edge.g3_mismatch)) : "-",
                   point_text(at),
                   is_near_miss(edge, profile) ? "near miss " + edge.note : edge.note});
    }
    Section section{"Edges, the worst first", std::move(table), {}, /*of_edges=*/true};
    section.brief = faulty_edges(result);
    return section;
}

Section knot_section(const CheckResult& result) {
    Table table({">face", "knot", "smooth to", ">gap [mm]", ">angle [deg]", ">curvature [%]", "at",
                 "remark"});
    Table faulty(table);
    for (const KnotLine& line : result.knots) {
        table.add({std::to_string(line.face),
                   fmt::format("{} = {:.6g}", line.is_u ? "u" : "v", line.knot),
                   line.parametric < 0 ? "nothing" : fmt::format("C{}", line.parametric),
                   short_number(line.max_gap), short_number(degrees(line.max_angle)),
                   percent_of(line.curvature_mismatch), point_text(line.at),
                   is_near_miss(line, result.profile) ? "near miss" : ""});
        if (is_near_miss(line, result.profile)) {
            faulty.add(table.rows().back());
        }
    }
    Section section{"Inside faces: knots that are no more than C1", std::move(table), {}};
    section.brief = std::move(faulty);
    return section;
}

/// Of all certified edges, how far the bounds lie above what was measured: the middle one, as a
/// part of the measured value or, where that is more, of a fifth of the limit.
double median_slack(const CheckResult& result) {
    constexpr double kPartOfLimit = 0.2;  // as certify_edges has it
    const Tolerance& limit = result.profile.tolerance;
    std::vector<double> slacks;
    for (std::size_t i = 0; i < result.certificates.size(); ++i) {
        const EdgeCertificate& proven = result.certificates[i];
        const EdgeContinuity& edge = result.report.edges[i];
        if (proven.certified) {
            slacks.push_back(std::max(
                (proven.gap - edge.max_gap) / std::max(edge.max_gap, kPartOfLimit * limit.linear),
                (proven.angle - edge.max_angle) /
                    std::max(edge.max_angle, kPartOfLimit * limit.angular)));
        }
    }
    if (slacks.empty()) {
        return 0.0;
    }
    const auto middle = slacks.begin() + static_cast<std::ptrdiff_t>(slacks.size() / 2);
    std::ranges::nth_element(slacks, middle);
    return *middle;
}

std::ptrdiff_t count_certified(const CheckResult& result) {
    return std::ranges::count(result.certificates, true, &EdgeCertificate::certified);
}

/// Proven, but too far above what was measured.
bool misses_slack(const EdgeCertificate& proven) {
    return proven.certified && !proven.within_slack;
}

Section certificate_section(const CheckResult& result) {
    Table table({">edge", "not certified because"});
    for (const EdgeCertificate& proven : result.certificates) {
        if (!proven.certified) {
            table.add({std::to_string(proven.edge), proven.reason});
        } else if (misses_slack(proven)) {
            table.add({std::to_string(proven.edge),
                       fmt::format("certified, but wider than the slack of {:g} % after {} "
                                   "stretches: gap {} mm, angle {} deg",
                                   100.0 * result.slack, proven.stretches, short_number(proven.gap),
                                   short_number(degrees(proven.angle)))});
        }
    }
    return {"Certificates",
            std::move(table),
            {fmt::format("bounds of gap and angle are proven for {} of {} edges; the median lies "
                         "{:.2g} % above what was measured",
                         count_certified(result), result.certificates.size(),
                         100.0 * median_slack(result))}};
}

Json certificate_json(const EdgeCertificate& proven) {
    Json json = {{"certified", proven.certified}};
    if (proven.certified) {
        json["gap_bound"] = proven.gap;
        json["angle_bound_deg"] = degrees(proven.angle);
        json["within_slack"] = proven.within_slack;
    } else {
        json["reason"] = proven.reason;
    }
    json["stretches"] = proven.stretches;
    return json;
}

Json summary_json(const CheckSummary& summary, const ContinuityReport& report) {
    return {{"edges", summary.edges},
            {"sharp", summary.sharp},
            {"G0", summary.g0},
            {"G1", summary.g1},
            {"G2", summary.g2},
            {"G3", summary.g3},
            {"near_misses", summary.near_misses},
            {"unmeasured", summary.unmeasured},
            {"knot_lines", summary.knot_lines},
            {"knot_near_misses", summary.knot_near_misses},
            {"max_gap", summary.max_gap},
            {"max_angle_deg", degrees(summary.max_angle)},
            {"free_edges", report.free_edges},
            {"non_manifold_edges", report.non_manifold}};
}

std::string verdict_of(const CheckSummary& summary, const Profile& profile) {
    const std::string limits = fmt::format("{} mm, {} deg", short_number(profile.tolerance.linear),
                                           short_number(degrees(profile.tolerance.angular)));
    std::string kinds = fmt::format("{} G3, {} G2, {} G1, {} G0, {} sharp", summary.g3, summary.g2,
                                    summary.g1, summary.g0, summary.sharp);
    if (summary.unmeasured > 0) {
        kinds += fmt::format("; {} could not be measured", counted(summary.unmeasured, "edge"));
    }
    if (summary.knot_near_misses > 0) {
        kinds += fmt::format("; {} inside faces", counted(summary.knot_near_misses, "near miss"));
    }
    if (summary.edges == 0) {
        return "no edge has two faces: there is nothing to measure";
    }
    if (summary.pass()) {
        return fmt::format("all of {} pass ({}): {}", counted(summary.edges, "edge"), limits,
                           kinds);
    }
    return fmt::format("{} of {} near misses, neither sharp nor within {}: {}", summary.near_misses,
                       counted(summary.edges, "edge"), limits, kinds);
}

Section shape_section(const CheckResult& result) {
    const Validity& validity = result.validity;
    Section section{"Shape",
                    Table({">solids", ">shells", ">faces", "closed", "valid", ">free edges",
                           ">largest tolerance [mm]"}),
                    validity.problems};
    section.table.add({std::to_string(validity.solids), std::to_string(validity.shells),
                       std::to_string(validity.faces), validity.closed ? "yes" : "no",
                       validity.valid ? "yes" : "no",
                       std::to_string(result.report.free_edges.size()),
                       short_number(validity.max_tolerance)});
    return section;
}

Json edges_json(const CheckResult& result) {
    Json edges = Json::array();
    for (std::size_t i = 0; i < result.report.edges.size(); ++i) {
        const EdgeContinuity& edge = result.report.edges[i];
        Json entry = json_of(edge);
        entry["near_miss"] = is_near_miss(edge, result.profile);
        entry["severity"] = severity(edge, result.profile);
        entry["fault"] = fault_of(edge, result.profile);
        if (!result.certificates.empty()) {
            entry["certificate"] = certificate_json(result.certificates[i]);
        }
        edges.push_back(std::move(entry));
    }
    return edges;
}

Json knots_json(const CheckResult& result) {
    Json lines = Json::array();
    for (const KnotLine& line : result.knots) {
        Json entry = json_of(line);
        entry["near_miss"] = is_near_miss(line, result.profile);
        lines.push_back(std::move(entry));
    }
    return lines;
}

}  // namespace

Outcome report_check(const Command& command, const std::shared_ptr<const CheckResult>& result) {
    const LoadedModel& model = result->model;
    Outcome outcome;
    outcome.exit_code = result->summary.pass() ? kDone : kOutOfTolerance;
    outcome.verdict = verdict_of(result->summary, result->profile);
    outcome.next =
        result->summary.pass() ? "" : "next: --report R.html shows them in 3D; -v lists all edges";
    outcome.document = {
        {"model", json_of(model.file)},
        {"sewing", json_of(model.sewing)},
        {"profile", report::json_of(result->profile)},
        {"edges", edges_json(*result)},
        {"face_knots", knots_json(*result)},
        {"summary", summary_json(result->summary, result->report)},
        {"shape", json_of(result->validity)},
        {"seconds",
         {{"read", model.seconds_read}, {"sew", model.seconds_sew}, {"check", result->seconds}}}};
    outcome.sections.push_back(edge_section(*result));
    if (!result->knots.empty()) {
        outcome.sections.push_back(knot_section(*result));
    }
    if (!result->certificates.empty()) {
        outcome.document["certificates"] = {
            {"certified", count_certified(*result)},
            {"edges", result->certificates.size()},
            {"beyond_slack", std::ranges::count_if(result->certificates, misses_slack)},
            {"slack_percent", 100.0 * result->slack},
            {"median_slack_percent", 100.0 * median_slack(*result)}};
        outcome.sections.push_back(certificate_section(*result));
    }
    outcome.sections.push_back(shape_section(*result));
    outcome.reports[".csv"] = [result](Run&) -> Result<std::string> { return csv_of(*result); };
    outcome.reports[".xml"] = [result, input = command.input](Run&) -> Result<std::string> {
        return junit_of(*result, input);
    };
    outcome.reports[".html"] = [result, &command, shown = std::make_shared<Outcome>(outcome)](
                                   Run& run) -> Result<std::string> {
        const Progress progress = run.stage(Stage::Checking, "drawing the model", 0.9, 1.0);
        const report::SceneInput input{.shape = result->model.whole,
                                       .before = {},
                                       .new_faces = {},
                                       .profile = result->profile,
                                       .report = result->report,
                                       .knots = result->knots,
                                       .summary = result->summary,
                                       .holes = {},
                                       .parts = scene_parts(result->model.file)};
        return report::make_scene(input, progress).map([&](const std::string& scene) {
            return html_report(command, *shown, scene);
        });
    };
    return outcome;
}

}  // namespace suture::cli

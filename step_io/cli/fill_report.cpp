#include "cli/fill_report.h"

#include "cli/report_json.h"
#include "files/losses.h"
#include "suture/base/text.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace suture::cli {
namespace {

struct Counts {
    int filled = 0, refused = 0, skipped = 0, out_of_tolerance = 0;
};

Counts count(const std::vector<HoleReport>& holes) {
    Counts counts;
    for (const HoleReport& hole : holes) {
        switch (hole.status) {
            case FillStatus::Filled:
                ++counts.filled;
                counts.out_of_tolerance += hole.verdict.within() ? 0 : 1;
                break;
            case FillStatus::Refused:
                ++counts.refused;
                break;
            case FillStatus::Skipped:
                ++counts.skipped;
                break;
        }
    }
    return counts;
}

std::string ids_of(const HoleReport& hole) {
    return fmt::format("{}", fmt::join(hole.ids, "+"));
}

std::string poles_of(const HoleReport& hole) {
    std::string text;
    for (const PatchFacts& patch : hole.patches) {
        text += text.empty() ? "" : ", ";
        text += patch.poles_u == 0 ? patch.kind
                                   : fmt::format("{}x{} poles", patch.poles_u, patch.poles_v);
    }
    return text;
}

/// Refused holes first, then the worst, then what was not asked for.
std::vector<std::size_t> worst_first(const std::vector<HoleReport>& holes) {
    std::vector<std::size_t> order(holes.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    const auto rank = [&](std::size_t index) {
        const HoleReport& hole = holes[index];
        const int group = hole.status == FillStatus::Refused   ? 0
                          : hole.status == FillStatus::Skipped ? 3
                          : hole.verdict.within()              ? 2
                                                               : 1;
        // What is far below the tolerance is equally good; such holes stay in their order.
        return std::tuple(group, hole.verdict.within() ? 0.0 : -hole.verdict.score);
    };
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return rank(a) < rank(b); });
    return order;
}

std::vector<std::string> row_of(const HoleReport& hole, int sides) {
    std::vector<std::string> row(11);
    row.front() = ids_of(hole);
    row[1] = std::to_string(sides);
    row.back() = hole.status == FillStatus::Filled
                     ? fmt::format("filled, {}", to_string(hole.verdict.severity))
                     : fmt::format("{}: {}", to_string(hole.status), hole.reason);
    if (hole.tried) {
        row[2] = hole.method_used;
        row[3] = poles_of(hole);
        row[4] = to_string(hole.continuity_requested);
        row[5] = to_string(hole.continuity_reached);
        row[6] = short_number(hole.max_gap);
        row[7] = short_number(degrees(hole.max_angle));
        row[8] = short_number(100.0 * hole.max_curvature_mismatch);
        row[9] = fmt::format("{:.2f}", hole.seconds);
    }
    return row;
}

/// One line for a hole.
std::vector<std::string> brief_row_of(const HoleReport& hole, int sides) {
    const std::vector<std::string> row = row_of(hole, sides);
    std::string result = hole.status == FillStatus::Filled
                             ? std::string(to_string(hole.verdict.severity))
                             : fmt::format("{}: {}", to_string(hole.status), hole.reason);
    constexpr std::size_t kMost = 40;  // so that it fits on a line
    return {row[0], row[1], row[2], row[5], row[6], row[7], shortened(result, kMost)};
}

Section hole_section(const FillSummary& summary) {
    Section section{"Holes",
                    Table({">hole", ">sides", "method", "surface", "asked", "reached", ">gap [mm]",
                           ">angle [deg]", ">curvature [%]", ">s", "result"}),
                    {}};
    section.notes_are_detail = true;
    section.brief =
        Table({">hole", ">sides", "method", "reached", ">gap [mm]", ">angle [deg]", "result"});
    for (const std::size_t index : worst_first(summary.holes)) {
        const HoleReport& hole = summary.holes[index];
        section.table.add(row_of(hole, summary.sides[index]));
        section.brief->add(brief_row_of(hole, summary.sides[index]));
        if (!hole.tried) {
            continue;
        }
        if (hole.status == FillStatus::Filled && !hole.reason.empty()) {
            section.notes.push_back(fmt::format("hole {}: {}", ids_of(hole), hole.reason));
        }
        for (const std::string& note : hole.notes) {
            section.notes.push_back(fmt::format("hole {}: {}", ids_of(hole), note));
        }
    }
    return section;
}

/// All findings, the holes' first.
std::vector<Finding> findings_of(const FillSummary& summary) {
    std::vector<Finding> findings;
    for (const HoleReport& hole : summary.holes) {
        findings.insert(findings.end(), hole.verdict.findings.begin(), hole.verdict.findings.end());
    }
    findings.insert(findings.end(), summary.findings.begin(), summary.findings.end());
    std::stable_sort(findings.begin(), findings.end(), is_worse);
    return findings;
}

/// What is not as it should be, the worst first: where a user would look next.
Section finding_section(const std::vector<Finding>& findings) {
    Section section{"Findings", Table({">hole", "severity", "finding"}), {}};
    for (const Finding& finding : findings) {
        section.table.add({finding.hole > 0 ? std::to_string(finding.hole) : "",
                           finding.before ? "before" : std::string(to_string(finding.severity)),
                           to_text(finding)});
    }
    return section;
}

bool invalid_before(const FillSummary& summary) {
    return std::any_of(summary.findings.begin(), summary.findings.end(), [](const Finding& f) {
        return f.kind == FindingKind::NotValid && f.before;
    });
}

std::string shape_of(const FillSummary& summary) {
    const Validity& validity = summary.validity;
    std::string text =
        validity.solids > 0 ? counted(validity.solids, "solid") : counted(validity.shells, "shell");
    text += validity.closed ? ", closed"
                            : fmt::format(", open ({})", counted(validity.free_edges, "free edge"));
    return text + (validity.valid            ? ", valid"
                   : invalid_before(summary) ? ", NOT valid, as the input was"
                                             : ", NOT valid");
}

/// The worst thing that was found, with its place and limit.
std::string worst_of(const std::vector<Finding>& findings) {
    if (findings.empty() || findings.front().before) {
        return {};
    }
    const Finding& worst = findings.front();
    return worst.hole > 0 ? fmt::format("; worst: {} (hole {})", to_text(worst), worst.hole)
                          : fmt::format("; worst: {}", to_text(worst));
}

/// What a user does next about holes that are not as they should be.
std::string next_of(const Counts& counts, const FillSummary& summary) {
    const auto bad = [](const HoleReport& hole) { return hole.status == FillStatus::Refused; };
    const auto rejected = std::ranges::find_if(summary.holes, bad);
    if (rejected != summary.holes.end()) {
        return fmt::format(
            "next: -v says why every method was refused; --report R.html shows hole {} in 3D",
            ids_of(*rejected));
    }
    return counts.out_of_tolerance > 0
               ? "next: --report R.html shows in 3D where it is out of tolerance; -v lists "
                 "everything"
               : "";
}

std::string verdict_of(const Counts& counts, const FillSummary& summary,
                       const FillSettings& settings, const std::vector<Finding>& findings) {
    std::string text;
    const int wanted = counts.filled + counts.refused;
    if (wanted == 0 && !summary.changes.empty()) {
        text = fmt::format("{}", fmt::join(summary.changes, "; "));
    } else if (wanted == 0) {
        text = "no hole to fill; " + text_of(summary.sewing) + summary.other_loops;
    } else {
        text = fmt::format("filled {} of {}", counts.filled, counted(wanted, "hole"));
        const Tolerance& tolerance = settings.request.tolerance;
        const std::string limits = fmt::format("{} mm and {} deg", short_number(tolerance.linear),
                                               short_number(degrees(tolerance.angular)));
        if (counts.out_of_tolerance > 0) {
            text += fmt::format(", {} out of tolerance ({})", counts.out_of_tolerance, limits);
        } else if (counts.filled > 0) {
            text += fmt::format(", within {}{}", limits,
                                findings.empty() || !findings.front().before
                                    ? ""
                                    : " or what the input itself allows");
        }
    }
    return fmt::format(
        "{}{}; {}; wrote {}{}", text, worst_of(findings), shape_of(summary),
        settings.output.string(),
        summary.measured_on == MeasuredOn::Memory ? " (measured before it became a mesh)" : "");
}

Severity severity_of(const std::vector<Finding>& findings) {
    Severity severity = Severity::Good;
    for (const Finding& finding : findings) {
        severity = finding.before ? severity : std::max(severity, finding.severity);
    }
    return severity;
}

Json json_of_seconds(const FillSeconds& seconds) {
    return {
        {"read", seconds.read},     {"detect", seconds.detect}, {"fill", seconds.fill},
        {"sew", seconds.sew},       {"check", seconds.check},   {"write", seconds.write},
        {"reread", seconds.reread}, {"choose", seconds.choose}, {"fill_step", seconds.fill_step}};
}

std::string_view name_of(MeasuredOn what) {
    switch (what) {
        case MeasuredOn::NewFaces:
            return "new faces";
        case MeasuredOn::File:
            return "file";
        case MeasuredOn::Memory:
            break;
    }
    return "memory";
}

}  // namespace

Json holes_of(const FillSummary& summary) {
    Json holes = Json::array();
    for (std::size_t i = 0; i < summary.holes.size(); ++i) {
        Json& entry = holes.emplace_back(json_of(summary.holes[i], summary.sides[i]));
        for (const HoleForm& form : summary.forms) {
            if (form.hole == summary.holes[i].ids.front()) {
                entry["polynomials"] = json_of(form.form);
            }
        }
    }
    return holes;
}

Outcome report_fill(const FillSummary& summary, const FillSettings& settings) {
    const Counts counts = count(summary.holes);
    const Tolerance& tolerance = settings.request.tolerance;
    Outcome outcome;
    const std::vector<Finding> findings = findings_of(summary);
    const Severity severity = severity_of(findings);
    const bool good = counts.refused == 0 && severity == Severity::Good;
    outcome.exit_code = good ? kDone : kOutOfTolerance;
    outcome.verdict = verdict_of(counts, summary, settings, findings);
    outcome.next = next_of(counts, summary);
    if (!summary.changes.empty()) {
        outcome.sections.push_back({"Changes", Table({}), summary.changes});
    }
    if (!summary.holes.empty()) {
        outcome.sections.push_back(hole_section(summary));
    }
    if (!findings.empty()) {
        outcome.sections.push_back(finding_section(findings));
    }
    if (!summary.validity.problems.empty()) {
        outcome.sections.push_back({"BRepCheck", Table({}), summary.validity.problems});
    }
    const std::vector<std::string> lost = io::lost_in(summary.file, settings.format);
    if (!lost.empty()) {
        outcome.sections.push_back({"Lost by this format", Table({}), lost});
    }
    Json listed = Json::array();
    for (const Finding& finding : findings) {
        listed.push_back(json_of(finding));
    }
    outcome.document = {{"output", settings.output.string()},
                        {"output_format", io::to_string(settings.format)},
                        {"model", json_of(summary.file)},
                        {"sewing", json_of(summary.sewing)},
                        {"changes", summary.changes},
                        {"lost", lost},
                        {"tolerance",
                         {{"gap_mm", tolerance.linear},
                          {"angle_deg", degrees(tolerance.angular)},
                          {"curvature_percent", 100.0 * tolerance.curvature}}},
                        {"severity", to_string(severity)},
                        {"findings", listed},
                        {"holes", holes_of(summary)},
                        {"measured_on", name_of(summary.measured_on)}};
    outcome.document.update(json_of(summary.validity));
    outcome.document["seconds"] = json_of_seconds(summary.seconds);
    return outcome;
}

}  // namespace suture::cli

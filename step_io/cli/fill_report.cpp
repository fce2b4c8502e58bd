#include "cli/fill_report.h"

#include "cli/report_json.h"
#include "files/losses.h"

#include <fmt/format.h>

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
                counts.out_of_tolerance += hole.within_tolerance ? 0 : 1;
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
std::vector<std::size_t> worst_first(const std::vector<HoleReport>& holes,
                                     const Tolerance& tolerance) {
    std::vector<std::size_t> order(holes.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    // What is far below the tolerance is equally good; such holes stay in their order.
    const auto steps = [](double value, double limit) { return std::floor(10.0 * value / limit); };
    const auto rank = [&](std::size_t index) {
        const HoleReport* hole = &holes[index];
        const int group = hole->status == FillStatus::Refused   ? 0
                          : hole->status == FillStatus::Skipped ? 3
                          : hole->within_tolerance              ? 2
                                                                : 1;
        return std::tuple(group, -steps(hole->max_angle, tolerance.angular),
                          -steps(hole->max_gap, tolerance.linear));
    };
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return rank(a) < rank(b); });
    return order;
}

std::vector<std::string> row_of(const HoleReport& hole, int sides) {
    if (hole.status != FillStatus::Filled) {
        std::vector<std::string> row(11);
        row.front() = ids_of(hole);
        row[1] = std::to_string(sides);
        row.back() = fmt::format("{}: {}", to_string(hole.status), hole.reason);
        return row;
    }
    return {ids_of(hole),
            std::to_string(sides),
            hole.method_used,
            poles_of(hole),
            std::string(to_string(hole.continuity_requested)),
            std::string(to_string(hole.continuity_reached)),
            short_number(hole.max_gap),
            short_number(degrees(hole.max_angle)),
            short_number(100.0 * hole.max_curvature_mismatch),
            fmt::format("{:.2f}", hole.seconds),
            hole.within_tolerance ? "filled" : "filled, out of tolerance"};
}

Section hole_section(const FillSummary& summary, const Tolerance& tolerance) {
    Section section{"Holes",
                    Table({">hole", ">sides", "method", "surface", "asked", "reached", ">gap [mm]",
                           ">angle [deg]", ">curvature [%]", ">s", "result"}),
                    {}};
    for (const std::size_t index : worst_first(summary.holes, tolerance)) {
        const HoleReport& hole = summary.holes[index];
        section.table.add(row_of(hole, summary.sides[index]));
        if (hole.status != FillStatus::Filled) {
            continue;
        }
        if (!hole.reason.empty()) {
            section.notes.push_back(fmt::format("hole {}: {}", ids_of(hole), hole.reason));
        }
        for (const std::string& note : hole.notes) {
            section.notes.push_back(fmt::format("hole {}: {}", ids_of(hole), note));
        }
    }
    return section;
}

bool side_fails(const SideReport& side, const Tolerance& tolerance) {
    return side.gap > tolerance.linear ||
           (side.requested >= Continuity::G1 && side.angle > tolerance.angular) ||
           (side.requested >= Continuity::G2 && side.curvature_mismatch > tolerance.curvature);
}

/// The sides that are out of tolerance: where a user would look next.
Section side_section(const FillSummary& summary, const Tolerance& tolerance) {
    Section section{"Sides out of tolerance",
                    Table({">hole", ">edge", ">neighbour", "asked", ">gap [mm]", ">angle [deg]",
                           ">curvature [%]"}),
                    {}};
    for (const HoleReport& hole : summary.holes) {
        for (const SideReport& side : hole.sides) {
            if (hole.status == FillStatus::Filled && side_fails(side, tolerance)) {
                section.table.add({ids_of(hole), std::to_string(side.edge),
                                   std::to_string(side.face),
                                   std::string(to_string(side.requested)), short_number(side.gap),
                                   short_number(degrees(side.angle)),
                                   short_number(100.0 * side.curvature_mismatch)});
            }
        }
    }
    return section;
}

std::string shape_of(const Validity& validity) {
    std::string text =
        validity.solids > 0 ? counted(validity.solids, "solid") : counted(validity.shells, "shell");
    text += validity.closed ? ", closed"
                            : fmt::format(", open ({})", counted(validity.free_edges, "free edge"));
    return text + (validity.valid ? ", valid" : ", NOT valid");
}

std::string verdict_of(const Counts& counts, const FillSummary& summary,
                       const FillSettings& settings) {
    std::string text;
    const int wanted = counts.filled + counts.refused;
    if (wanted == 0) {
        text = fmt::format("no hole to fill; {} sewn at {} mm",
                           counted(summary.sewing.loose_faces, "loose face"),
                           short_number(summary.sewing.tolerance));
    } else {
        text = fmt::format("filled {} of {}", counts.filled, counted(wanted, "hole"));
        const Tolerance& tolerance = settings.request.tolerance;
        if (counts.out_of_tolerance > 0) {
            text += fmt::format(", {} out of tolerance ({} mm, {} deg)", counts.out_of_tolerance,
                                short_number(tolerance.linear),
                                short_number(degrees(tolerance.angular)));
        } else if (counts.filled > 0) {
            text += fmt::format(", within {} mm and {} deg", short_number(tolerance.linear),
                                short_number(degrees(tolerance.angular)));
        }
    }
    return fmt::format(
        "{}; {}; wrote {}{}", text, shape_of(summary.validity), settings.output.string(),
        summary.measured_on == MeasuredOn::Memory ? " (measured before it became a mesh)" : "");
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

Outcome report_fill(const FillSummary& summary, const FillSettings& settings) {
    const Counts counts = count(summary.holes);
    const Tolerance& tolerance = settings.request.tolerance;
    Outcome outcome;
    const bool good = counts.refused == 0 && counts.out_of_tolerance == 0 && summary.validity.valid;
    outcome.exit_code = good ? kDone : kOutOfTolerance;
    outcome.verdict = verdict_of(counts, summary, settings);
    if (!summary.holes.empty()) {
        outcome.sections.push_back(hole_section(summary, tolerance));
    }
    Section sides = side_section(summary, tolerance);
    if (!sides.table.empty()) {
        outcome.sections.push_back(std::move(sides));
    }
    if (!summary.validity.problems.empty()) {
        outcome.sections.push_back({"BRepCheck", Table({}), summary.validity.problems});
    }
    const std::vector<std::string> lost = io::lost_in(summary.file, settings.format);
    if (!lost.empty()) {
        outcome.sections.push_back({"Lost by this format", Table({}), lost});
    }
    Json holes = Json::array();
    for (std::size_t i = 0; i < summary.holes.size(); ++i) {
        holes.push_back(json_of(summary.holes[i], summary.sides[i]));
    }
    outcome.document = {{"output", settings.output.string()},
                        {"output_format", io::to_string(settings.format)},
                        {"model", json_of(summary.file)},
                        {"sewing", json_of(summary.sewing)},
                        {"lost", lost},
                        {"tolerance",
                         {{"gap_mm", tolerance.linear},
                          {"angle_deg", degrees(tolerance.angular)},
                          {"curvature_percent", 100.0 * tolerance.curvature}}},
                        {"holes", holes},
                        {"measured_on", name_of(summary.measured_on)}};
    outcome.document.update(json_of(summary.validity));
    outcome.document["seconds"] = json_of_seconds(summary.seconds);
    return outcome;
}

}  // namespace suture::cli

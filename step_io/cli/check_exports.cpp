#include "cli/check_exports.h"

#include "suture/base/text.h"

#include <fmt/ranges.h>

#include <array>

namespace suture::cli {
namespace {

std::string csv_field(std::string_view text) {
    if (text.find_first_of(",\"\r\n") == text.npos) {
        return std::string(text);
    }
    std::string quoted = "\"";
    for (const char c : text) {
        quoted += c == '"' ? "\"\"" : std::string(1, c);
    }
    return quoted + '"';
}

std::string case_of(std::string_view suite, std::string_view name, std::string_view kind,
                    std::string_view message) {
    std::string text = fmt::format("    <testcase classname=\"{}\" name=\"{}\"",
                                   escape_markup(suite), escape_markup(name));
    if (kind.empty()) {
        return text + "/>\n";
    }
    return text + fmt::format("><{0} message=\"{1}\">{1}</{0}></testcase>\n", kind,
                              escape_markup(message));
}

std::string at_text(const Eigen::Vector3d& at) {
    return fmt::format("({:.9g} {:.9g} {:.9g})", at.x(), at.y(), at.z());
}

}  // namespace

std::string csv_of(const CheckResult& result) {
    std::string text =
        "edge,face1,face2,class,near_miss,length_mm,max_gap_mm,max_angle_deg,mean_angle_deg,"
        "min_angle_deg,curvature_mismatch_percent,curvature_mismatch_sum_percent,"
        "curvature_difference_per_mm,opposite_concavity,g3_mismatch_deg,angle_at_x,angle_at_y,"
        "angle_at_z,angle_along,gap_at_x,gap_at_y,gap_at_z,gap_along,samples,note\r\n";
    for (const EdgeContinuity& edge : worst_first(result.report.edges, result.profile)) {
        text += fmt::format(
            "{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{}\r\n",
            edge.edge, edge.faces[0], edge.faces[1], to_string(edge.edge_class),
            is_near_miss(edge, result.profile) ? 1 : 0, edge.length, edge.max_gap,
            degrees(edge.max_angle), degrees(edge.mean_angle), degrees(edge.min_angle),
            100.0 * edge.curvature_mismatch, 100.0 * edge.curvature_mismatch_sum,
            edge.curvature_difference, edge.opposite_concavity ? 1 : 0,
            edge.g3_samples > 0 ? fmt::to_string(degrees(edge.g3_mismatch)) : "", edge.angle_at.x(),
            edge.angle_at.y(), edge.angle_at.z(), edge.angle_along, edge.gap_at.x(),
            edge.gap_at.y(), edge.gap_at.z(), edge.gap_along, edge.samples, csv_field(edge.note));
    }
    return text;
}

std::string junit_of(const CheckResult& result, const std::filesystem::path& input) {
    const CheckSummary& summary = result.summary;
    const std::string suite = input.filename().string();
    std::string cases;
    for (const EdgeContinuity& edge : worst_first(result.report.edges, result.profile)) {
        const std::string name = fmt::format("Edge{} between Face{} and Face{}", edge.edge,
                                             edge.faces[0], edge.faces[1]);
        if (edge.samples == 0) {
            cases += case_of(suite, name, "error", "could not be measured: " + edge.note);
        } else if (is_near_miss(edge, result.profile)) {
            const bool gap = edge.max_gap > result.profile.tolerance.linear;
            cases += case_of(suite, name, "failure",
                             fault_of(edge, result.profile) + " at " +
                                 at_text(gap ? edge.gap_at : edge.angle_at));
        } else {
            cases += case_of(suite, name, "", "");
        }
    }
    for (const KnotLine& line : result.knots) {
        const std::string name =
            fmt::format("Face{} knot {} = {:.9g}", line.face, line.is_u ? "u" : "v", line.knot);
        const bool fails = is_near_miss(line, result.profile);
        cases += case_of(suite, name, fails ? "failure" : "",
                         fmt::format("gap {:.4g} mm, angle {:.4g} deg inside a face at {}",
                                     line.max_gap, degrees(line.max_angle), at_text(line.at)));
    }
    return fmt::format(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites>\n"
        "  <testsuite name=\"{}\" tests=\"{}\" failures=\"{}\" errors=\"{}\" time=\"{:.3f}\">\n"
        "{}  </testsuite>\n</testsuites>\n",
        escape_markup("suture check " + suite), summary.edges + summary.knot_lines,
        summary.near_misses + summary.knot_near_misses, summary.unmeasured, result.seconds, cases);
}

}  // namespace suture::cli

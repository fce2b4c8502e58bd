#include "cli/shell_output.h"

#include "cli/report_json.h"
#include "files/new_model.h"
#include "files/write.h"
#include "suture/base/contract.h"
#include "suture/check/continuity.h"

#include <algorithm>

namespace suture::cli {

Result<ShellOutput> write_shell(Run& run, const Command& command, const TopoDS_Shell& shell,
                                io::Format format, double from) {
    SUTURE_EXPECTS(!command.outputs.empty());
    const std::filesystem::path& file = command.outputs.front();
    const double middle = 0.5 * (from + 1.0);
    Progress progress = run.stage(Stage::Checking, "measuring edges", from, middle);
    const auto report = measure_continuity(shell, Profile(), {}, progress);
    if (!report) {
        return tl::unexpected(report.error());
    }
    ShellOutput output;
    for (const EdgeContinuity& edge : report->edges) {
        output.max_gap = std::max(output.max_gap, edge.max_gap);
        output.max_angle = std::max(output.max_angle, edge.max_angle);
    }
    output.validity = measure_validity(shell);
    progress = run.stage(Stage::Writing, "writing " + file.filename().string(), middle, 1.0);
    const auto model = io::make_model(shell, command.input.stem().string());
    if (!model) {
        return tl::unexpected(model.error());
    }
    const auto written = io::write_model(*model, file, format, {});
    if (!written) {
        return tl::unexpected(written.error());
    }
    return output;
}

Json json_of(const ShellOutput& output) {
    return {{"max_gap", output.max_gap},
            {"max_angle_deg", degrees(output.max_angle)},
            {"shape", json_of(output.validity)}};
}

}  // namespace suture::cli

#include "cli/fill_page.h"

#include "cli/report_html.h"
#include "cli/scene_parts.h"

#include "report/scene.h"

namespace suture::cli {
namespace {

Result<report::SceneInput> measured_scene(const FillSummary& summary, const Tolerance& tolerance,
                                          const Progress& progress) {
    report::SceneInput input;
    input.shape = summary.file.shape();
    input.before = summary.before;
    input.new_faces = summary.new_faces;
    input.profile.name = "fill";
    input.profile.source = "the limits of this fill";
    input.profile.tolerance = tolerance;
    Result<ContinuityReport> report = measure_continuity(input.shape, input.profile, {}, progress);
    if (!report) {
        return tl::unexpected(report.error());
    }
    Result<std::vector<KnotLine>> knots = measure_face_knots(input.shape, progress);
    if (!knots) {
        return tl::unexpected(knots.error());
    }
    input.report = std::move(*report);
    input.knots = std::move(*knots);
    input.summary = summarise(input.report, input.knots, input.profile);
    input.holes = scene_holes(summary);
    input.parts = scene_parts(summary.file);
    return input;
}

}  // namespace

Result<std::string> fill_scene(const FillSummary& summary, const Tolerance& tolerance,
                               const Progress& progress) {
    return measured_scene(summary, tolerance, progress)
        .and_then(
            [&](const report::SceneInput& input) { return report::make_scene(input, progress); });
}

void add_fill_page(const Command& command, const std::shared_ptr<const FillSummary>& summary,
                   const Tolerance& tolerance, Outcome& outcome) {
    outcome.reports[".html"] =
        [&command, summary, tolerance,
         shown = std::make_shared<Outcome>(outcome)](Run& run) -> Result<std::string> {
        const Progress progress = run.stage(Stage::Checking, "drawing the model", 0.9, 1.0);
        return fill_scene(*summary, tolerance, progress).map([&](const std::string& scene) {
            return html_report(command, *shown, scene);
        });
    };
}

}  // namespace suture::cli

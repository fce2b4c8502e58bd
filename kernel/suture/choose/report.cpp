#include "suture/choose/report.h"

#include <algorithm>
#include <limits>

namespace suture {

std::string_view to_string(FillStatus status) {
    constexpr std::string_view kNames[] = {"filled", "refused", "skipped"};
    return kNames[static_cast<int>(status)];
}

void set_figures(const FillMeasures& measures, HoleReport& report) {
    constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
    report.tried = true;
    report.max_gap = report.max_angle = report.max_curvature_mismatch = 0.0;
    const auto raise = [&](const EdgeContinuity& edge, Continuity wanted) {
        report.max_gap = std::max(report.max_gap, edge.max_gap);
        // Where only position was asked for, the angle is the design's, not an error.
        if (wanted >= Continuity::G1) {
            report.max_angle = std::max(report.max_angle, edge.max_angle);
            report.max_curvature_mismatch =
                std::max(report.max_curvature_mismatch, edge.curvature_mismatch);
        }
    };
    bool any = !measures.inner.empty();
    for (std::size_t i = 0; i < report.sides.size(); ++i) {
        SideReport& side = report.sides[i];
        const EdgeContinuity& edge = measures.sides[i];
        if (edge.samples == 0) {
            side.gap = side.angle = side.curvature_mismatch = kUnknown;
            continue;
        }
        any = true;
        side.gap = edge.max_gap;
        side.angle = edge.max_angle;
        side.curvature_mismatch = edge.curvature_mismatch;
        raise(edge, side.requested);
    }
    for (const EdgeContinuity& edge : measures.inner) {
        raise(edge, report.continuity_requested);
    }
    if (!any) {
        report.max_gap = report.max_angle = report.max_curvature_mismatch = kUnknown;
    }
    report.max_distance_through = measures.through;
    report.max_angle_through = measures.through_angle;
    report.continuity_reached = reached_by(report.asked, measures);
    report.verdict = judge_fill(report.asked, measures);
}

}  // namespace suture

#include "suture/fill/mvs.h"

#include "suture/fill/mvs/fairing.h"
#include "suture/fill/mvs/layout.h"
#include "suture/fill/mvs/remember.h"
#include "suture/fill/mvs/schedule.h"

namespace suture {
namespace {

// The surface's least area element, against the mean: below, it folds or has no normal to speak of.
constexpr double kLeastRegularity = 1e-4;
// A surface this far from a neighbour's tangent plane has turned over there.
constexpr double kMostAngle = 0.5 * kPi;

Patch patch_of(const mvs::Fairing& fairing) {
    const mvs::Net& net = fairing.net;
    const double length = fairing.scale.length;
    SplineSurface surface;
    surface.degree_u = surface.degree_v = mvs::kDegree;
    surface.knots_u = net.u.knots;
    surface.knots_v = net.v.knots;
    // The domain in model units as well: its curves are as long as the edges.
    for (double& knot : surface.knots_u) {
        knot *= length;
    }
    for (double& knot : surface.knots_v) {
        knot *= length;
    }
    surface.poles = (net.poles * length).colwise() + fairing.scale.centre;
    Patch patch;
    patch.surface = std::move(surface);
    for (const mvs::DomainLoop& loop : fairing.domain.loops) {
        std::vector<TrimCurve> trims;
        for (const mvs::DomainCurve& curve : loop.curves) {
            trims.emplace_back([curve](double s) { return curve.at(s); });
        }
        patch.wires.push_back(wire_of_loop(static_cast<int>(patch.wires.size()), std::move(trims)));
    }
    return patch;
}

// Corners at which no surface can be tangent to both neighbours.
void note_corners(const Hole& hole, const Tolerance& tolerance, std::vector<std::string>& notes) {
    for (const RibbonLoop& loop : hole.loops) {
        const std::vector<mvs::Corner> corners = mvs::corners_of(loop);
        for (std::size_t i = 0; i < corners.size(); ++i) {
            if (corners[i].mismatch > tolerance.angular) {
                const std::size_t before = (i + corners.size() - 1) % corners.size();
                notes.push_back(fmt::format(
                    "where {} meets {}, at ({:.6g}, {:.6g}, {:.6g}), the neighbours' normals "
                    "differ "
                    "by {:.3g} deg: no face is tangent to both there",
                    name_of(loop.ribbons[before]), name_of(loop.ribbons[i]), corners[i].point.x(),
                    corners[i].point.y(), corners[i].point.z(), degrees(corners[i].mismatch)));
            }
        }
    }
}

}  // namespace

Result<FillResult> fill_mvs(const Hole& hole, const FillOptions& options) {
    mvs::Schedule schedule;
    schedule.most_work *= find_number(options.own, "work").value_or(1.0);
    return fill_mvs(hole, options, schedule);
}

Result<FillResult> fill_mvs(const Hole& asked, const FillOptions& options,
                            const mvs::Schedule& schedule) {
    const Hole hole = mvs::remember(asked);
    const RibbonLoop& loop = hole.loops.front();
    const Result<mvs::Layout> layout = mvs::lay_out(loop, hole.diameter);
    if (!layout) {
        return tl::unexpected(layout.error());
    }
    const Result<mvs::Fairing> fairing = mvs::fair(hole, *layout, options, schedule);
    if (!fairing) {
        return tl::unexpected(fairing.error());
    }
    if (fairing->regularity < kLeastRegularity) {
        return fail(ErrorCode::Refused,
                    "the surface folds: its area element falls to {:.2g} of the mean (limit {})",
                    fairing->regularity, kLeastRegularity);
    }
    if (fairing->worst.angle > kMostAngle) {
        return fail(ErrorCode::Refused,
                    "the surface meets a neighbour at {:.1f} deg (limit {:.0f})",
                    degrees(fairing->worst.angle), degrees(kMostAngle));
    }
    FillResult result;
    result.patches.push_back(patch_of(*fairing));
    result.notes.push_back(
        fmt::format("{} x {} poles after {} steps; at ribbon samples between the fitted ones: gap "
                    "{:.2g}, angle {:.2g} deg",
                    fairing->net.u.count(), fairing->net.v.count(), fairing->steps,
                    fairing->worst.gap * fairing->scale.length, degrees(fairing->worst.angle)));
    if (fairing->lines > 0) {
        result.notes.push_back(fmt::format(
            "neighbours agree in normal but not in curvature at corners: {} knot line{} through "
            "them, across which the curvature may jump",
            fairing->lines, fairing->lines == 1 ? "" : "s"));
    }
    if (fairing->exhausted) {
        result.notes.emplace_back(
            "a finer net would take too much computing: --effort thorough may come nearer");
    }
    for (const std::string& side : fairing->tangent_only) {
        result.notes.push_back(side +
                               ": continuous curvature would cost gap or angle, tangent only");
    }
    if (layout->kind != mvs::LayoutKind::Development) {
        result.notes.push_back(fmt::format(
            "the boundary turns by {:.1f} deg on its neighbours and crosses itself when unrolled: "
            "laid out as a {} instead",
            degrees(layout->turning),
            layout->kind == mvs::LayoutKind::Polygon ? "polygon" : "circle"));
    }
    note_corners(hole, options.tolerance, result.notes);
    return result;
}

}  // namespace suture

#include "suture/fill_holes.h"

#include "suture/check/continuity.h"
#include "suture/choose/select.h"
#include "suture/choose/smoothest.h"
#include "suture/choose/wishes.h"
#include "suture/detect/find_loops.h"
#include "suture/faces/join.h"
#include "suture/faces/make_faces.h"
#include "suture/faces/unite_corners.h"
#include "suture/ribbon/extract.h"

#include <TopoDS.hxx>

#include <algorithm>
#include <chrono>

namespace suture {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

PatchFacts facts_of(const Patch& patch) {
    PatchFacts facts;
    facts.kind = kind_name(patch.surface);
    facts.exact = patch.exact;
    facts.fit_error = patch.fit_error;
    if (const auto* spline = std::get_if<SplineSurface>(&patch.surface)) {
        facts.degree_u = spline->degree_u;
        facts.degree_v = spline->degree_v;
        facts.poles_u = spline->count_u();
        facts.poles_v = spline->count_v();
        facts.rational = spline->rational();
    }
    return facts;
}

/// A gap below what the model's own edges are good for cannot be asked for.
Tolerance reachable(const FillRequest& request, const Hole& hole, HoleReport& report) {
    Tolerance tolerance = request.tolerance;
    if (hole.tolerance > tolerance.linear) {
        tolerance.linear = hole.tolerance;
        report.notes.push_back(
            fmt::format("the model's own edges here are only good to {:.3g}: gaps are judged "
                        "against that",
                        hole.tolerance));
    }
    return tolerance;
}

/// What is in the report before anything is computed.
HoleReport begin_report(const std::vector<BoundaryLoop>& loops, const FillRequest& request) {
    HoleReport report;
    for (const BoundaryLoop& loop : loops) {
        report.ids.push_back(loop.id);
    }
    report.method_requested = request.method;
    return report;
}

/// What every ribbon should do, as the wishes have it.
void ask(Hole& hole, const std::vector<Wish>& wishes) {
    std::size_t next = 0;
    for (RibbonLoop& loop : hole.loops) {
        for (Ribbon& ribbon : loop.ribbons) {
            ribbon.continuity = wishes[next++].continuity;
        }
    }
}

void report_wishes(const Hole& hole, const std::vector<Wish>& wishes, HoleReport& report) {
    report.sides.clear();
    report.continuity_requested = Continuity::G0;
    for (const RibbonLoop& loop : hole.loops) {
        for (const Ribbon& ribbon : loop.ribbons) {
            const Wish& wish = wishes[report.sides.size()];
            SideReport& side = report.sides.emplace_back();
            side.edge = ribbon.edge;
            side.face = ribbon.face;
            side.requested = wish.continuity;
            side.reason = wish.reason;
            report.continuity_requested = std::max(report.continuity_requested, wish.continuity);
        }
    }
}

/// The measures of the sides, their maxima, and what they amount to.
void conclude(const TrialMeasure& measured, const Tolerance& tolerance, HoleReport& report) {
    const std::vector<SideMeasure>& sides = measured.sides;
    const SideMeasure& inner = measured.inner;
    bool g1 = score_of(inner, Continuity::G1, tolerance) <= 1.0;
    bool g2 = score_of(inner, Continuity::G2, tolerance) <= 1.0;
    report.within_tolerance = score_of(inner, report.continuity_requested, tolerance) <= 1.0;
    report.max_gap = inner.gap;
    report.max_angle = report.continuity_requested >= Continuity::G1 ? inner.angle : 0.0;
    report.max_curvature_mismatch =
        report.continuity_requested >= Continuity::G1 ? inner.curvature_mismatch : 0.0;
    for (std::size_t i = 0; i < sides.size(); ++i) {
        SideReport& side = report.sides[i];
        side.gap = sides[i].gap;
        side.angle = sides[i].angle;
        side.curvature_mismatch = sides[i].curvature_mismatch;
        report.max_gap = std::max(report.max_gap, side.gap);
        // Where only position was asked for, the angle is the design's, not an error.
        if (side.requested >= Continuity::G1) {
            report.max_angle = std::max(report.max_angle, side.angle);
            report.max_curvature_mismatch =
                std::max(report.max_curvature_mismatch, side.curvature_mismatch);
        }
        g1 = g1 && score_of(sides[i], Continuity::G1, tolerance) <= 1.0;
        g2 = g2 && score_of(sides[i], Continuity::G2, tolerance) <= 1.0;
        report.within_tolerance =
            report.within_tolerance && score_of(sides[i], side.requested, tolerance) <= 1.0;
    }
    report.continuity_reached = g2 ? Continuity::G2 : g1 ? Continuity::G1 : Continuity::G0;
}

/// Fills one hole: its faces stand on the model's edges afterwards; none where it was refused. Adds
/// its seconds to those of the outcome.
Result<std::vector<TopoDS_Face>> fill_one(const std::vector<BoundaryLoop>& loops,
                                          const FillRequest& request, HoleReport& report,
                                          FillOutcome& outcome) {
    auto hole = extract_hole(loops);
    if (!hole) {
        return tl::unexpected(hole.error());
    }
    hole->through = report.through = request.through;
    std::vector<Wish> wishes = wishes_for(*hole, request);
    ask(*hole, wishes);
    const Tolerance tolerance = reachable(request, *hole, report);
    const auto start = Clock::now();
    const auto choice = choose_smoothest(loops, *hole, wishes, request, tolerance);
    outcome.seconds_choose += seconds_since(start);
    report_wishes(*hole, wishes, report);
    if (!choice) {
        return tl::unexpected(choice.error());
    }
    outcome.seconds_fill += choice->seconds;
    auto made = make_faces(loops, *hole, choice->fill);
    if (!made) {
        return tl::unexpected(made.error());
    }
    report.method_used = choice->method;
    report.reason = choice->reason;
    report.notes.insert(report.notes.end(), choice->fill.notes.begin(), choice->fill.notes.end());
    if (made->grown_edges > 0) {
        report.notes.push_back(
            fmt::format("the tolerance of {} edges had to grow, at most to {:.3g}",
                        made->grown_edges, made->grown_tolerance));
    }
    for (const Patch& patch : choice->fill.patches) {
        report.patches.push_back(facts_of(patch));
    }
    report.implicit = choice->fill.implicit;
    conclude(choice->measured, tolerance, report);
    report.max_distance_through = choice->measured.through;
    report.within_tolerance =
        report.within_tolerance && report.max_distance_through <= tolerance.linear;
    return made->faces;
}

}  // namespace

Result<FillOutcome> fill_holes(const TopoDS_Shape& shape, const occ::Numbering& numbering,
                               const FillRequest& request) {
    if (auto valid = validate(request.tolerance); !valid) {
        return tl::unexpected(valid.error());
    }
    if (auto valid = validate_method(request.method); !valid) {
        return tl::unexpected(valid.error());
    }
    if (auto valid = validate_options(request.method, options_of(request.method), request.options);
        !valid) {
        return tl::unexpected(valid.error());
    }
    const auto loops = find_loops(shape, numbering);
    if (!loops) {
        return tl::unexpected(loops.error());
    }
    const auto selection = select_holes(*loops, request);
    if (!selection) {
        return tl::unexpected(selection.error());
    }
    if (!request.through.empty() && selection->holes.size() != 1) {
        return fail(ErrorCode::Usage,
                    "points to pass through belong to one hole, not to {}: choose it with --hole",
                    selection->holes.size());
    }
    FillOutcome outcome;
    for (std::size_t i = 0; i < selection->holes.size(); ++i) {
        const auto& hole = selection->holes[i];
        const auto start = Clock::now();
        request.progress(static_cast<double>(i) / static_cast<double>(selection->holes.size()),
                         fmt::format("filling hole {}", hole.front().id));
        HoleReport report = begin_report(hole, request);
        unite_corners(shape, hole);
        const auto faces = fill_one(hole, request, report, outcome);
        if (faces) {
            report.status = FillStatus::Filled;
            outcome.new_faces.insert(outcome.new_faces.end(), faces->begin(), faces->end());
        } else if (faces.error().code == ErrorCode::Cancelled) {
            return tl::unexpected(faces.error());
        } else {
            report.status = FillStatus::Refused;
            report.reason = faces.error().message;
        }
        report.seconds = seconds_since(start);
        outcome.holes.push_back(std::move(report));
    }
    const auto start = Clock::now();
    auto joined =
        outcome.new_faces.empty() ? Result<TopoDS_Shape>(shape) : join(shape, outcome.new_faces);
    if (!joined) {
        return tl::unexpected(joined.error());
    }
    outcome.shape = std::move(*joined);
    outcome.seconds_sew = seconds_since(start);
    outcome.holes.insert(outcome.holes.end(), selection->skipped.begin(), selection->skipped.end());
    return outcome;
}

}  // namespace suture

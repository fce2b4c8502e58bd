#include "suture/flow/compute.h"

#include "suture/choose/asked.h"
#include "suture/choose/smoothest.h"
#include "suture/faces/own_form.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <chrono>
#include <mutex>

namespace suture {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

PatchFacts facts_of(const Patch& patch, const std::optional<OwnForm>& own) {
    PatchFacts facts;
    facts.kind = own ? own->kind : kind_name(patch.surface);
    facts.exact = patch.exact;
    facts.fit_error = patch.fit_error;
    if (own) {
        return facts;
    }
    if (const auto* spline = std::get_if<SplineSurface>(&patch.surface)) {
        facts.degree_u = spline->degree_u;
        facts.degree_v = spline->degree_v;
        facts.poles_u = spline->count_u();
        facts.poles_v = spline->count_v();
        facts.rational = spline->rational();
    }
    return facts;
}

/// Names the kind that the face has, not that of the method's copy of it.
void rename_kind(const std::string& kind, Recognised& recognised, std::vector<std::string>& notes) {
    const std::string before = "recognised: " + recognised.kind;
    for (std::string& note : notes) {
        if (note.starts_with(before)) {
            note.replace(0, before.size(), "recognised: " + kind);
        }
    }
    recognised.kind = kind;
}

/// What is in the report before anything is computed.
HoleReport begin_report(const std::vector<BoundaryLoop>& loops, const FillRequest& request) {
    HoleReport report;
    for (const BoundaryLoop& loop : loops) {
        report.ids.push_back(loop.id);
    }
    report.method_requested = request.method;
    report.status = FillStatus::Refused;
    return report;
}

void report_wishes(const std::vector<BoundaryLoop>& loops, const Hole& hole,
                   const std::vector<Wish>& wishes, HoleReport& report) {
    report.continuity_requested = Continuity::G0;
    for (std::size_t l = 0; l < loops.size(); ++l) {
        for (std::size_t i = 0; i < loops[l].edges.size(); ++i) {
            const Ribbon& ribbon = hole.loops[l].ribbons[i];
            const Wish& wish = wishes[report.sides.size()];
            SideReport& side = report.sides.emplace_back();
            side.edge = ribbon.edge;
            side.face = ribbon.face;
            side.on_edge = loops[l].edges[i].edge;
            side.support = loops[l].edges[i].support;
            side.requested = wish.continuity;
            side.reason = wish.reason;
            report.continuity_requested = std::max(report.continuity_requested, wish.continuity);
        }
    }
}

/// Numbers of faces are those of the copies on which the fill was tried.
void forget_numbers_of_copies(HoleReport& report) {
    for (Finding& finding : report.verdict.findings) {
        finding.face = finding.other_face = 0;
    }
    for (Clash& clash : report.clashes) {
        clash.face = clash.other = 0;
    }
    for (Overlay& overlay : report.overlays) {
        overlay.face = overlay.other = 0;
    }
}

std::string why_bad(const HoleReport& report) {
    return fmt::format(
        "the best fill is bad and stays out of the model (--keep-bad puts it in): {}",
        to_text(report.verdict.findings.front()));
}

void take(Choice choice, const FillRequest& request, ComputedFill& computed) {
    HoleReport& report = computed.report;
    report.method_used = choice.method;
    report.reason = choice.reason;
    report.notes = choice.fill.notes;
    for (const Patch& patch : choice.fill.patches) {
        const auto own = own_form_of(patch, computed.loops, computed.hole);
        report.patches.push_back(facts_of(patch, own));
        if (own && choice.recognised) {
            rename_kind(own->kind, *choice.recognised, report.notes);
        }
    }
    account_for(choice.fill, choice.recognised.has_value(), choice.twin, report.asked);
    set_figures(choice.measures, report);
    report.clashes = std::move(choice.measures.clashes);
    report.overlays = std::move(choice.measures.overlays);
    forget_numbers_of_copies(report);
    if (report.verdict.severity == Severity::Bad && !request.keep_bad) {
        report.notes.push_back(std::move(report.reason));
        report.reason = why_bad(report);
        return;
    }
    report.status = FillStatus::Filled;
    report.recognised = std::move(choice.recognised);
    computed.fill = std::move(choice.fill);
    computed.placements = std::move(choice.placements);
}

ComputedFill compute_fill(const TopoDS_Shape& shape, const HolePlan& plan,
                          const occ::Numbering* numbering, const FillRequest& request) {
    const auto start = Clock::now();
    ComputedFill computed;
    computed.loops = plan.loops;
    computed.report = begin_report(plan.loops, request);
    if (!plan.hole) {
        computed.report.reason = plan.hole.error().message;
        return computed;
    }
    computed.hole = *plan.hole;
    computed.report.through = request.through;
    std::vector<Wish> wishes = plan.wishes;
    const Site site{shape, plan.loops, plan.candidates, plan.guides, plan.spoilt, numbering};
    auto choice = choose_smoothest(site, computed.hole, wishes, request, request.tolerance);
    computed.seconds_choose = seconds_since(start);
    report_wishes(plan.loops, computed.hole, wishes, computed.report);
    computed.report.asked = asked_of(plan.loops, computed.hole, wishes, request.tolerance);
    if (choice) {
        computed.seconds_fill = choice->seconds;
        take(std::move(*choice), request, computed);
    } else {
        computed.report.reason = choice.error().message;
    }
    computed.report.seconds = seconds_since(start);
    return computed;
}

}  // namespace

Result<std::vector<ComputedFill>> compute_fills(const TopoDS_Shape& shape, const FillPlan& plan,
                                                const FillRequest& request) {
    std::vector<ComputedFill> computed(plan.holes.size());
    std::mutex reporting;
    std::size_t done = 0;
    request.progress(0.0, fmt::format("filling holes, 0 of {} done", plan.holes.size()));
    FillRequest one = request;
    one.progress.report = {};  // the methods' own fractions would run over each other
    tbb::parallel_for(std::size_t{0}, plan.holes.size(), [&](std::size_t i) {
        if (request.progress.cancelled()) {
            return;
        }
        computed[i] = compute_fill(shape, plan.holes[i], plan.numbering, one);
        const std::lock_guard lock(reporting);
        ++done;
        request.progress(static_cast<double>(done) / static_cast<double>(plan.holes.size()),
                         fmt::format("filling holes, {} of {} done", done, plan.holes.size()));
    });
    if (request.progress.cancelled()) {
        return fail(ErrorCode::Cancelled, "stopped while filling");
    }
    return computed;
}

}  // namespace suture

#include "suture/flow/apply.h"

#include "suture/faces/join.h"
#include "suture/faces/make_faces.h"
#include "suture/faces/unite_corners.h"

#include <fmt/format.h>

#include <chrono>

namespace suture {
namespace {

using Clock = std::chrono::steady_clock;

/// The faces of one fill on the shape's own edges. What was computed has been made on copies
/// before, so that it is not refused here.
void apply_fill(const TopoDS_Shape& shape, ComputedFill& fill, FillOutcome& outcome) {
    HoleReport& report = fill.report;
    unite_corners(shape, fill.loops);
    auto made = make_faces(fill.loops, fill.hole, fill.fill);
    if (!made) {
        report.status = FillStatus::Refused;
        report.reason = made.error().message;
        return;
    }
    if (made->grown_edges > 0) {
        report.notes.push_back(
            fmt::format("the tolerance of {} edges had to grow, at most to {:.3g}",
                        made->grown_edges, made->grown_tolerance));
    }
    outcome.new_faces.insert(outcome.new_faces.end(), made->faces.begin(), made->faces.end());
    if (fill.fill.implicit) {
        outcome.forms.push_back({report.ids.front(), std::move(*fill.fill.implicit)});
    }
}

}  // namespace

Result<FillOutcome> apply_fills(const TopoDS_Shape& shape, std::vector<ComputedFill> fills) {
    const auto start = Clock::now();
    FillOutcome outcome;
    for (ComputedFill& fill : fills) {
        if (fill.report.status == FillStatus::Filled) {
            apply_fill(shape, fill, outcome);
        }
        outcome.seconds_fill += fill.seconds_fill;
        outcome.seconds_choose += fill.seconds_choose;
        outcome.holes.push_back(std::move(fill.report));
    }
    auto joined =
        outcome.new_faces.empty() ? Result<TopoDS_Shape>(shape) : join(shape, outcome.new_faces);
    if (!joined) {
        return tl::unexpected(joined.error());
    }
    outcome.shape = std::move(*joined);
    outcome.seconds_sew = std::chrono::duration<double>(Clock::now() - start).count();
    return outcome;
}

}  // namespace suture

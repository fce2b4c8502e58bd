#include "suture/flow/apply.h"

#include "suture/faces/join.h"
#include "suture/faces/make_faces.h"
#include "suture/faces/unite_corners.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <chrono>
#include <optional>

namespace suture {
namespace {

using Clock = std::chrono::steady_clock;

using PlacedFill = std::optional<Result<PlacedFaces>>;

/// Where the faces of the fills lie on the shape's own edges.
std::vector<PlacedFill> place_all(const TopoDS_Shape& shape, std::vector<ComputedFill>& fills) {
    for (ComputedFill& fill : fills) {
        if (fill.report.status == FillStatus::Filled) {
            unite_corners(shape, fill.loops);
        }
    }
    std::vector<PlacedFill> placed(fills.size());
    tbb::parallel_for(std::size_t{0}, fills.size(), [&](std::size_t i) {
        const ComputedFill& fill = fills[i];
        if (fill.report.status == FillStatus::Filled) {
            placed[i] = place_faces(fill.loops, fill.hole, fill.fill, fill.placements);
        }
    });
    return placed;
}

/// The faces of one fill. What was computed has been made on copies before, so that it is not
/// refused here.
void apply_fill(Result<PlacedFaces>& placed, ComputedFill& fill, FillOutcome& outcome) {
    HoleReport& report = fill.report;
    auto made = placed ? placed->make() : tl::unexpected(placed.error());
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
    std::vector<PlacedFill> placed = place_all(shape, fills);
    for (std::size_t i = 0; i < fills.size(); ++i) {
        ComputedFill& fill = fills[i];
        if (placed[i]) {
            apply_fill(*placed[i], fill, outcome);
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

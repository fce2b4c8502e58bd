#include "suture/choose/smoothest.h"

#include <fmt/format.h>

#include <algorithm>

namespace suture {
namespace {

/// A mismatch this near to its limit may be above it in the file, where numbers are rounded.
constexpr double kSafe = 0.9;

/// Calls action(ribbon, index) for every side, in the order of the loops.
template <class Action>
void for_each_side(Hole& hole, Action&& action) {
    std::size_t next = 0;
    for (RibbonLoop& loop : hole.loops) {
        for (Ribbon& ribbon : loop.ribbons) {
            action(ribbon, next++);
        }
    }
}

}  // namespace

Result<Choice> choose_smoothest(const std::vector<BoundaryLoop>& loops, Hole& hole,
                                std::vector<Wish>& wishes, const FillRequest& request,
                                const Tolerance& tolerance) {
    if (std::none_of(wishes.begin(), wishes.end(), [](const Wish& w) { return w.hoped; })) {
        return choose_fill(loops, hole, request, tolerance);
    }
    auto smooth = choose_fill(loops, hole, request, tolerance, Effort::Quick);
    if (!smooth && smooth.error().code == ErrorCode::Cancelled) {
        return smooth;
    }
    bool good = smooth.has_value() && smooth->measured.through <= tolerance.linear;
    for_each_side(hole, [&](Ribbon& ribbon, std::size_t i) {
        Wish& wish = wishes[i];
        const SideMeasure side = smooth ? smooth->measured.sides[i] : SideMeasure();
        if (wish.hoped && (!smooth || side.curvature_mismatch > kSafe * tolerance.curvature)) {
            wish.continuity = ribbon.continuity = Continuity::G1;
            wish.reason = smooth
                              ? fmt::format(
                                    "auto: continuous curvature was tried, and is reached to "
                                    "{:.3g} %",
                                    100.0 * side.curvature_mismatch)
                              : "auto: continuous curvature was tried: " + smooth.error().message;
        }
        good = good && smooth && score_of(side, wish.continuity, tolerance) <= 1.0;
    });
    if (good) {
        return smooth;
    }
    for_each_side(hole, [&](Ribbon& ribbon, std::size_t i) {
        if (wishes[i].hoped && wishes[i].continuity == Continuity::G2) {
            wishes[i].continuity = ribbon.continuity = Continuity::G1;
            wishes[i].reason = "auto: with continuous curvature gap or angle are out of tolerance";
        }
    });
    auto choice = choose_fill(loops, hole, request, tolerance);
    if (choice && smooth) {
        choice->seconds += smooth->seconds;
    }
    return choice;
}

}  // namespace suture

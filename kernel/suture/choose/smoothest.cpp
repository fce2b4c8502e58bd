#include "suture/choose/smoothest.h"

#include "suture/check/profile.h"
#include "suture/choose/asked.h"
#include "suture/fill/fill.h"
#include "suture/judge/judge_fill.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <utility>

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

/// A tangent fill that is sharper than this along a side is none: what the check calls a sharp
/// edge.
const double kSharp = Profile().sharp;

/// Beyond this an angle tells nothing: the surface has folded back.
constexpr double kFolded = radians(90.0);

/// Whether a fill can be worked with but for sides that are sharp.
bool is_shaped(const Result<Choice>& choice) {
    return choice &&
           std::none_of(choice->verdict.findings.begin(), choice->verdict.findings.end(),
                        [](const Finding& finding) {
                            return finding.severity == Severity::Bad && !finding.before &&
                                   (finding.kind != FindingKind::Angle || finding.value > kFolded);
                        });
}

/// Whether a fill is as sharp along an edge as the model was.
bool was_sharp(int edge, const Choice& choice) {
    return std::ranges::any_of(choice.verdict.findings, [&](const Finding& finding) {
        return finding.kind == FindingKind::Angle && finding.edge == edge && finding.before;
    });
}

/// Which sides ask for tangency by our own choice and came out sharp; none without a fill.
std::vector<bool> sharp_sides(Hole& hole, const std::vector<Wish>& wishes,
                              const Result<Choice>& choice) {
    std::vector<bool> sharp(wishes.size(), false);
    if (!is_shaped(choice)) {
        return sharp;
    }
    for_each_side(hole, [&](const Ribbon& ribbon, std::size_t i) {
        sharp[i] = wishes[i].own && wishes[i].continuity == Continuity::G1 &&
                   choice->measures.sides[i].max_angle > kSharp && !was_sharp(ribbon.edge, *choice);
    });
    return sharp;
}

bool any(const std::vector<bool>& sides) {
    return std::find(sides.begin(), sides.end(), true) != sides.end();
}

std::string why_not_tangent(const Result<Choice>& tangent) {
    return "auto: position only, for tangency was tried: " +
           (tangent ? tangent->reason : tangent.error().message);
}

/// Asks for position only along these sides.
void relax(const std::vector<bool>& sides, const std::string& why, Hole& hole,
           std::vector<Wish>& wishes) {
    const std::vector<bool> walls = walls_of(hole);
    for_each_side(hole, [&](Ribbon& ribbon, std::size_t i) {
        if (sides[i] && wishes[i].own) {
            wishes[i] = {Continuity::G0,    why,     /*hoped=*/false, /*own=*/false,
                         /*given_up=*/true, walls[i]};
            ribbon.continuity = Continuity::G0;
        }
    });
}

/// Methods that `auto` tries do without tangency as well as with it; the others are built on it,
/// and OCCT's filling has its own ways to do without.
bool does_without_tangency(const std::string& method) {
    const auto rows = fill_methods();
    return method == "auto" || std::any_of(rows.begin(), rows.end(), [&](const FillMethod& row) {
               const bool taken =
                   row.in_auto != AutoUse::Improving && row.in_auto != AutoUse::Never;
               return taken && row.id == method;
           });
}

/// So many times nearer the other sides have to come for one to give its tangency up.
constexpr double kGain = 2.0;

/// The same with position alone along single sides whose normals are no surface's at both their
/// ends: what they miss there, a fill that is tangent to them spreads over all others. Nothing
/// where there are none, or the others do not gain.
std::optional<Choice> without_odd_sides(const Site& site, Hole& hole, std::vector<Wish>& wishes,
                                        const FillRequest& request, const Tolerance& tolerance,
                                        const Choice& tangent) {
    const std::vector<bool> odd = odd_sides(hole, tolerance.angular);
    Hole relaxed = hole;
    std::vector<Wish> fewer = wishes;
    relax(odd, "auto: position only, for at both ends the neighbour's normal is not the others'",
          relaxed, fewer);
    AskedFill others = asked_of(site.loops, relaxed, {}, tolerance);
    account_for(tangent.fill, tangent.recognised.has_value(), tangent.twin, others);
    const double before = judge_fill(others, tangent.measures).score;
    if (!std::ranges::any_of(fewer, &Wish::given_up) || before <= 1.0) {
        return std::nullopt;
    }
    auto choice = choose_fill(site, relaxed, request, tolerance, Tries::Own);
    if (!choice || choice->verdict.severity == Severity::Bad) {
        return std::nullopt;
    }
    for (std::size_t i = 0; i < fewer.size(); ++i) {
        if (fewer[i].given_up && choice->measures.sides[i].max_angle > kSharp) {
            return std::nullopt;
        }
    }
    account_for(choice->fill, choice->recognised.has_value(), choice->twin, others);
    if (kGain * judge_fill(others, choice->measures).score > before) {
        return std::nullopt;
    }
    hole = std::move(relaxed);
    wishes = std::move(fewer);
    return *std::move(choice);
}

/// The fill that is tangent where that was asked for, or the one that gives it up where the hole's
/// walls have no tangent fill.
///
/// Input    earlier: what the methods of our own gave when they were asked for more.
Result<Choice> choose_tangent(const Site& site, Hole& hole, std::vector<Wish>& wishes,
                              const FillRequest& request, const Tolerance& tolerance,
                              std::optional<Choice> earlier = {}) {
    const bool ours =
        std::any_of(wishes.begin(), wishes.end(), [](const Wish& w) { return w.own; });
    if (!ours || !does_without_tangency(request.method)) {
        return choose_fill(site, hole, request, tolerance);
    }
    auto tangent = earlier ? choose_further(site, hole, request, tolerance, *std::move(earlier),
                                            Left::Improving)
                           : choose_fill(site, hole, request, tolerance, Tries::Own);
    const bool shaped = is_shaped(tangent);
    const std::vector<bool> sharp = sharp_sides(hole, wishes, tangent);
    if (!tangent && tangent.error().code == ErrorCode::Cancelled) {
        return tangent;
    }
    const bool automatic = request.method == "auto";
    if (shaped && !any(sharp)) {
        if (auto choice = without_odd_sides(site, hole, wishes, request, tolerance, *tangent)) {
            choice->seconds += tangent->seconds;
            return *std::move(choice);
        }
        return tangent->near() || !automatic
                   ? std::move(tangent)
                   : choose_further(site, hole, request, tolerance, std::move(tangent), Left::Slow);
    }
    double seconds = tangent ? tangent->seconds : 0.0;
    const std::string why = why_not_tangent(tangent);
    const std::vector<bool> all(wishes.size(), true);
    for (const std::vector<bool>& sides : {shaped ? sharp : steep_sides(hole), all}) {
        if (!any(sides)) {
            continue;
        }
        Hole relaxed = hole;
        std::vector<Wish> fewer = wishes;
        relax(sides, why, relaxed, fewer);
        auto choice = choose_fill(site, relaxed, request, tolerance, Tries::Own);
        seconds += choice ? choice->seconds : 0.0;
        if (choice && choice->near() && !any(sharp_sides(relaxed, fewer, choice))) {
            choice->seconds = seconds;
            hole = std::move(relaxed);
            wishes = std::move(fewer);
            return choice;
        }
    }
    if (!automatic) {
        return tangent;
    }
    const double before = tangent ? tangent->seconds : 0.0;
    auto choice = choose_further(site, hole, request, tolerance, std::move(tangent), Left::Slow);
    if (choice) {
        choice->seconds += seconds - before;
        if (choice->relaxed) {
            relax(all, why, hole, wishes);
        }
    }
    return choice;
}

}  // namespace

Result<Choice> choose_smoothest(const Site& site, Hole& hole, std::vector<Wish>& wishes,
                                const FillRequest& request, const Tolerance& tolerance) {
    if (std::none_of(wishes.begin(), wishes.end(), [](const Wish& w) { return w.hoped; })) {
        return choose_tangent(site, hole, wishes, request, tolerance);
    }
    auto smooth = choose_fill(site, hole, request, tolerance, Tries::Own);
    if (!smooth && smooth.error().code == ErrorCode::Cancelled) {
        return smooth;
    }
    for_each_side(hole, [&](Ribbon& ribbon, std::size_t i) {
        Wish& wish = wishes[i];
        const double mismatch = smooth ? smooth->measures.sides[i].curvature_mismatch : 0.0;
        if (wish.hoped && (!smooth || mismatch > kSafe * tolerance.curvature)) {
            wish.continuity = ribbon.continuity = Continuity::G1;
            wish.reason = smooth
                              ? fmt::format(
                                    "auto: continuous curvature was tried, and is reached to "
                                    "{:.3g} %",
                                    100.0 * mismatch)
                              : "auto: continuous curvature was tried: " + smooth.error().message;
        }
    });
    const auto within = [&](Choice& choice) {
        AskedFill asked = asked_of(site.loops, hole, wishes, tolerance);
        account_for(choice.fill, choice.recognised.has_value(), choice.twin, asked);
        choice.verdict = judge_fill(asked, choice.measures);
        return choice.verdict.within();
    };
    if (smooth && within(*smooth)) {
        return smooth;
    }
    for_each_side(hole, [&](Ribbon& ribbon, std::size_t i) {
        if (wishes[i].hoped && wishes[i].continuity == Continuity::G2) {
            wishes[i].continuity = ribbon.continuity = Continuity::G1;
            wishes[i].reason =
                "auto: with continuous curvature gap, angle or the face inside are out of "
                "tolerance";
        }
    });
    if (smooth && smooth->method == "mvs") {
        // It has given up what cost gap or angle, and would do the same again. What was out of
        // tolerance may have been the curvature across its own knot lines, which nobody asks for
        // now.
        if (within(*smooth)) {
            return smooth;
        }
        return choose_tangent(site, hole, wishes, request, tolerance, *std::move(smooth));
    }
    auto choice = choose_tangent(site, hole, wishes, request, tolerance);
    if (choice && smooth) {
        choice->seconds += smooth->seconds;
    }
    return choice;
}

}  // namespace suture

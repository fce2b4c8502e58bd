#include "suture/choose/choose.h"

#include "suture/fill/fill.h"

#include <algorithm>
#include <chrono>
#include <functional>

namespace suture {
namespace {

using Clock = std::chrono::steady_clock;

/// A method together with all that it needs.
struct Attempt {
    std::string name;
    std::function<Result<FillResult>()> fill;
};

bool position_only(const Hole& hole) {
    return std::all_of(hole.loops.begin(), hole.loops.end(), [](const RibbonLoop& loop) {
        return std::all_of(loop.ribbons.begin(), loop.ribbons.end(), [](const Ribbon& ribbon) {
            return ribbon.continuity == Continuity::G0;
        });
    });
}

std::vector<Attempt> attempts_for(const std::vector<BoundaryLoop>& loops, const Hole& hole,
                                  const FillRequest& request, const Tolerance& tolerance) {
    const bool automatic = request.method == "auto";
    std::vector<Attempt> attempts;
    for (const FillMethod& method : fill_methods()) {
        if (automatic || request.method == method.id) {
            attempts.push_back({std::string(method.id), [&, method] {
                                    return method.fill(hole, {tolerance, request.progress});
                                }});
        }
    }
    if (automatic && position_only(hole)) {
        // A lid, not the ball or the tip that a rim could also belong to.
        std::stable_partition(attempts.begin(), attempts.end(),
                              [](const Attempt& attempt) { return attempt.name == "plane"; });
    }
    const auto plate = [&](PlateSetting setting) {
        const std::string name = setting == PlateSetting::Tuned ? "occt (tuned)" : "occt";
        attempts.push_back({name, [&, setting] {
                                return fill_with_plate(loops, hole, setting, request.plate_limit,
                                                       request.progress);
                            }});
    };
    if (automatic) {
        plate(PlateSetting::Default);
        plate(PlateSetting::Tuned);
    } else if (request.method == "occt") {
        plate(request.plate_setting);
    }
    return attempts;
}

/// Beyond these `auto` takes no candidate, however much worse the others are: a surface that is off
/// by a fiftieth of the hole, or folded back at its border, closes nothing.
constexpr double kHopelessGap = 0.02;
constexpr double kHopelessAngle = radians(90.0);

bool hopeless(const TrialMeasure& measured, const Hole& hole) {
    std::size_t next = 0;
    for (const RibbonLoop& loop : hole.loops) {
        for (const Ribbon& ribbon : loop.ribbons) {
            const SideMeasure& side = measured.sides[next++];
            if (side.gap > kHopelessGap * hole.diameter ||
                (ribbon.continuity >= Continuity::G1 && side.angle > kHopelessAngle)) {
                return true;
            }
        }
    }
    return false;
}

/// One sentence on a candidate: "occt: 1.5 times the tolerance".
std::string verdict(const std::string& name, double score) {
    return score <= 1.0 ? fmt::format("{}: within tolerance", name)
                        : fmt::format("{}: {:.3g} times the tolerance", name, score);
}

}  // namespace

Result<void> validate_method(const std::string& method) {
    std::string known = "auto";
    for (const FillMethod& row : fill_methods()) {
        if (row.id == method) {
            return {};
        }
        known += fmt::format(", {}", row.id);
    }
    if (method == "auto" || method == "occt") {
        return {};
    }
    return fail(ErrorCode::Usage, "there is no method '{}'; the methods are {}, occt", method,
                known);
}

Result<Choice> choose_fill(const std::vector<BoundaryLoop>& loops, const Hole& hole,
                           const FillRequest& request, const Tolerance& tolerance) {
    const bool automatic = request.method == "auto";
    std::optional<Choice> best;
    std::vector<std::string> verdicts;
    double seconds = 0.0;
    for (const Attempt& attempt : attempts_for(loops, hole, request, tolerance)) {
        if (request.progress.cancelled()) {
            return fail(ErrorCode::Cancelled, "stopped while filling");
        }
        const auto start = Clock::now();
        auto fill = attempt.fill();
        seconds += std::chrono::duration<double>(Clock::now() - start).count();
        if (!fill) {
            verdicts.push_back(attempt.name + ": " + fill.error().message);
            continue;
        }
        auto measured = try_fill(loops, hole, *fill, tolerance, request.progress);
        if (!measured) {
            verdicts.push_back(attempt.name + ": " + measured.error().message);
            continue;
        }
        verdicts.push_back(verdict(attempt.name, measured->score));
        if (automatic && hopeless(*measured, hole)) {
            verdicts.back() += " (far off or folded back: not taken)";
            continue;
        }
        if (!best || measured->score < best->measured.score) {
            best = Choice{attempt.name, std::move(*fill), std::move(*measured), {}, 0.0};
        }
        if (best->measured.score <= 1.0) {
            break;
        }
    }
    if (!best) {
        return fail(ErrorCode::Refused, "{}", fmt::join(verdicts, "; "));
    }
    best->seconds = seconds;
    best->reason = automatic ? fmt::format("{}", fmt::join(verdicts, "; ")) : "as asked";
    return *best;
}

}  // namespace suture

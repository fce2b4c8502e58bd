#include "suture/choose/choose.h"

#include "suture/choose/asked.h"
#include "suture/fill/fill.h"
#include "suture/ribbon/noise.h"

#include <algorithm>
#include <chrono>
#include <compare>
#include <functional>

namespace suture {
namespace {

using Clock = std::chrono::steady_clock;

/// A method together with all that it needs.
struct Attempt {
    std::string name;
    /// Sets what was recognised, if anything.
    std::function<Result<FillResult>(std::optional<Recognised>&)> fill;
    bool closer = false;       ///< for a hole that the others miss by a little
    bool slow = false;         ///< OCCT's filling
    bool last_resort = false;  ///< position only, where nothing else is worth taking
};

bool position_only(const Hole& hole) {
    return std::all_of(hole.loops.begin(), hole.loops.end(), [](const RibbonLoop& loop) {
        return std::all_of(loop.ribbons.begin(), loop.ribbons.end(), [](const Ribbon& ribbon) {
            return ribbon.continuity == Continuity::G0;
        });
    });
}

bool wants_curvature(const Hole& hole) {
    return std::any_of(hole.loops.begin(), hole.loops.end(), [](const RibbonLoop& loop) {
        return std::any_of(loop.ribbons.begin(), loop.ribbons.end(), [](const Ribbon& ribbon) {
            return ribbon.continuity >= Continuity::G2;
        });
    });
}

/// The same hole with position alone wanted along every side.
Hole without_tangency(Hole hole) {
    for (RibbonLoop& loop : hole.loops) {
        for (Ribbon& ribbon : loop.ribbons) {
            ribbon.continuity = Continuity::G0;
        }
    }
    return hole;
}

/// The same hole with position alone wanted along the sides of which the request says nothing.
Hole with_own_wishes_given_up(Hole hole, const FillRequest& request) {
    for (RibbonLoop& loop : hole.loops) {
        for (Ribbon& ribbon : loop.ribbons) {
            if (!request.continuity && !request.edge_continuity.contains(ribbon.edge)) {
                ribbon.continuity = Continuity::G0;
            }
        }
    }
    return hole;
}

/// The same hole with tangency wanted where continuous curvature was only hoped for: the face that
/// was lost had none there either.
Hole without_hopes(Hole hole, const FillRequest& request) {
    for (RibbonLoop& loop : hole.loops) {
        for (Ribbon& ribbon : loop.ribbons) {
            if (!request.continuity && !request.edge_continuity.contains(ribbon.edge)) {
                ribbon.continuity = std::min(ribbon.continuity, Continuity::G1);
            }
        }
    }
    return hole;
}

/// Whether `auto` does without a method here.
bool left_out(const FillMethod& method, const Hole& hole, const FillRequest& request) {
    switch (method.in_auto) {
        case AutoUse::Always:
            return false;
        case AutoUse::Recognising:
            return !request.recognise;
        case AutoUse::Bridging:
            return !request.connect;
        case AutoUse::NearMiss:
            return request.effort == Effort::Quick || position_only(hole) ||
                   (wants_curvature(hole) && method.highest < Continuity::G2);
        case AutoUse::Never:
            break;
    }
    return true;
}

std::string plate_name(PlateSetting setting, bool relaxed) {
    const bool tuned = setting == PlateSetting::Tuned;
    return relaxed ? (tuned ? "occt (tuned, position only)" : "occt (position only)")
                   : (tuned ? "occt (tuned)" : "occt");
}

/// For `occt` the first attempt is what was asked for, and the others are there for holes over
/// which that surface folds.
std::vector<Attempt> attempts_for(const Site& site, const Hole& hole, const FillRequest& request,
                                  const Tolerance& tolerance) {
    const bool automatic = request.method == "auto";
    FillOptions options{tolerance, request.progress, request.options};
    options.noise = measure_noise(site.loops, hole);
    options.candidates = site.candidates;
    options.prefer = request.prefer;
    std::vector<Attempt> attempts;
    for (const FillMethod& method : fill_methods()) {
        if (automatic ? !left_out(method, hole, request) : request.method == method.id) {
            attempts.push_back({std::string(method.id),
                                [&, method, options](std::optional<Recognised>& found) {
                                    FillOptions own = options;
                                    own.recognised = [&](const Recognised& what) { found = what; };
                                    return method.fill(hole, own);
                                },
                                /*closer=*/automatic && method.in_auto == AutoUse::NearMiss});
        }
    }
    std::stable_partition(attempts.begin(), attempts.end(),
                          [](const Attempt& attempt) { return !attempt.closer; });
    if (automatic && position_only(hole)) {
        // A lid, not the ball or the tip that a rim could also belong to.
        std::stable_partition(attempts.begin(), attempts.end(),
                              [](const Attempt& attempt) { return attempt.name == "plane"; });
    }
    const auto plate = [&](PlateSetting setting, bool relaxed = false) {
        attempts.push_back({plate_name(setting, relaxed),
                            [&, setting, relaxed](std::optional<Recognised>& /*found*/) {
                                return fill_with_plate(
                                    site.loops, relaxed ? without_tangency(hole) : hole, setting,
                                    request.plate_limit, request.progress);
                            },
                            /*closer=*/false, /*slow=*/true,
                            /*last_resort=*/automatic && relaxed});
    };
    if (automatic) {
        plate(PlateSetting::Default);
        if (request.effort == Effort::Thorough) {
            plate(PlateSetting::Tuned);
        }
        plate(PlateSetting::Default, /*relaxed=*/true);
    } else if (request.method == "occt") {
        for (const PlateSetting setting : {request.plate_setting, PlateSetting::Default}) {
            plate(setting);
            if (!position_only(hole)) {
                plate(setting, /*relaxed=*/true);
            }
            if (setting == PlateSetting::Default) {
                break;
            }
        }
    }
    return attempts;
}

/// OCCT's filling can take a minute. On the holes measured it never came noticeably nearer than a
/// candidate that is within so many times the tolerance: there it is the model's own noise that is
/// left.
constexpr double kNear = 30.0;

/// Whether an attempt can be better than the best so far, and may take its time.
bool worthwhile(const Attempt& attempt, const std::optional<Choice>& best,
                const FillRequest& request, Tries tries) {
    const bool near = best && best->near();
    if (attempt.closer) {
        return near;
    }
    if (!attempt.slow) {
        return true;
    }
    const bool usable = best && best->verdict.severity != Severity::Bad;
    return tries == Tries::All && !(near && request.method == "auto") &&
           !(attempt.last_resort && usable);
}

/// How a candidate stands among the others: the less the better.
struct Rank {
    bool bad = false;
    double score = 0.0;
    auto operator<=>(const Rank&) const = default;
};

Rank rank_of(const Judgement& verdict) {
    return {verdict.severity == Severity::Bad, verdict.score};
}

/// One sentence on a candidate: "occt: 1.5 times the tolerance".
std::string sentence(const std::string& name, const Judgement& verdict) {
    if (verdict.within()) {
        return fmt::format("{}: within tolerance", name);
    }
    if (verdict.severity == Severity::Bad) {
        return fmt::format("{}: {}", name, to_text(verdict.findings.front()));
    }
    return fmt::format("{}: {:.3g} times the tolerance", name, verdict.score);
}

}  // namespace

bool Choice::near() const {
    return verdict.severity != Severity::Bad && verdict.score <= kNear;
}

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

std::span<const MethodOption> options_of(std::string_view method) {
    const auto rows = fill_methods();
    const auto row =
        std::find_if(rows.begin(), rows.end(), [&](const FillMethod& m) { return m.id == method; });
    return row == rows.end() ? std::span<const MethodOption>() : row->options;
}

Result<Choice> choose_fill(const Site& site, const Hole& hole, const FillRequest& request,
                           const Tolerance& tolerance, Tries tries) {
    const bool automatic = request.method == "auto";
    const AskedFill asked = asked_of(site.loops, hole, {}, tolerance);
    const AskedFill less =
        asked_of(site.loops, with_own_wishes_given_up(hole, request), {}, tolerance);
    const AskedFill unhoped = asked_of(site.loops, without_hopes(hole, request), {}, tolerance);
    std::optional<Choice> best;
    std::vector<std::string> verdicts;
    double seconds = 0.0;
    for (const Attempt& attempt : attempts_for(site, hole, request, tolerance)) {
        if (request.progress.cancelled()) {
            return fail(ErrorCode::Cancelled, "stopped while filling");
        }
        if (std::find(site.spoilt.begin(), site.spoilt.end(), attempt.name) != site.spoilt.end()) {
            verdicts.push_back(attempt.name + ": worse in the written file");
            continue;
        }
        if (!worthwhile(attempt, best, request, tries)) {
            const bool named = automatic && !attempt.last_resort && best && best->near();
            if (named) {
                verdicts.push_back(attempt.name + ": not tried");
            }
            continue;
        }
        const auto start = Clock::now();
        std::optional<Recognised> recognised;
        auto fill = attempt.fill(recognised);
        seconds += std::chrono::duration<double>(Clock::now() - start).count();
        if (!fill) {
            verdicts.push_back(attempt.name + ": " + fill.error().message);
            continue;
        }
        auto trial = try_fill(site, hole, *fill, tolerance, request.progress);
        if (!trial) {
            verdicts.push_back(attempt.name + ": " + trial.error().message);
            continue;
        }
        AskedFill wanted = attempt.last_resort ? less : recognised ? unhoped : asked;
        account_for(*fill, recognised.has_value(), wanted);
        Judgement verdict = judge_fill(wanted, trial->measures);
        // Clashes take longest: they are looked for where all else is good enough to be taken.
        if (verdict.severity != Severity::Bad &&
            (!best || rank_of(verdict) < rank_of(best->verdict))) {
            if (auto done = add_clashes(site, hole, tolerance, request.progress, *trial); !done) {
                verdicts.push_back(attempt.name + ": " + done.error().message);
                continue;
            }
            verdict = judge_fill(wanted, trial->measures);
        }
        verdicts.push_back(sentence(attempt.name, verdict));
        if (!best || rank_of(verdict) < rank_of(best->verdict)) {
            best = Choice{attempt.name,
                          std::move(*fill),
                          std::move(trial->measures),
                          std::move(verdict),
                          {},
                          0.0,
                          std::move(recognised)};
        }
        const bool bad = best->verdict.severity == Severity::Bad;
        if (best->verdict.within() || (!automatic && !bad)) {
            break;
        }
    }
    if (!best) {
        return fail(ErrorCode::Refused, "{}", fmt::join(verdicts, "; "));
    }
    best->seconds = seconds;
    const bool as_asked = !automatic && verdicts.size() == 1;
    best->reason = as_asked ? "as asked" : fmt::format("{}", fmt::join(verdicts, "; "));
    return *best;
}

}  // namespace suture

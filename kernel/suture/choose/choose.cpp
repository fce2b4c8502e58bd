#include "suture/choose/choose.h"

#include "suture/choose/asked.h"
#include "suture/choose/attempts.h"
#include "suture/fill/fill.h"

#include <algorithm>
#include <chrono>
#include <compare>

namespace suture {
namespace {

using Clock = std::chrono::steady_clock;

/// The same hole with position alone wanted along the sides of which the request says nothing.
Hole with_own_wishes_given_up(Hole hole, const FillRequest& request) {
    for (RibbonLoop& loop : hole.loops) {
        for (Ribbon& ribbon : loop.ribbons) {
            if (!request.continuity && !request.edge_continuity.contains(ribbon.edge) &&
                !request.supports.contains(ribbon.edge)) {
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

/// OCCT's filling can take a minute. On the holes measured it never came noticeably nearer than a
/// candidate that is within so many times the tolerance: there it is the model's own noise that is
/// left.
constexpr double kNear = 30.0;

/// Whether an attempt can be better than the best so far, and may take its time.
bool worthwhile(const Attempt& attempt, const std::optional<Choice>& best, bool automatic) {
    const bool usable = best && best->verdict.severity != Severity::Bad;
    return !(attempt.improving && !usable) && !(attempt.last_resort && usable) &&
           !(attempt.slow && automatic && best && best->near());
}

/// So many surfaces that are recognised are tried where one after the other is bad.
constexpr int kRecognised = 4;

/// How a candidate stands among the others: the less the better.
struct Rank {
    bool bad = false;
    double score = 0.0;
    auto operator<=>(const Rank&) const = default;
};

Rank rank_of(const Judgement& verdict) {
    return {verdict.severity == Severity::Bad, verdict.score};
}

/// The figures of a candidate: "gap 2e-06, angle 0.003 deg, curvature 1.2 %, 18 x 23 poles".
std::string figures(const FillResult& fill, const FillMeasures& measures) {
    double gap = 0.0;
    double angle = 0.0;
    double curvature = 0.0;
    for (const EdgeContinuity& side : measures.sides) {
        gap = std::max(gap, side.max_gap);
        angle = std::max(angle, side.max_angle);
        curvature = std::max(curvature, side.curvature_mismatch);
    }
    std::string text = fmt::format("gap {:.2g}, angle {:.2g} deg, curvature {:.2g} %", gap,
                                   degrees(angle), 100.0 * curvature);
    for (const Patch& patch : fill.patches) {
        if (const auto* spline = std::get_if<SplineSurface>(&patch.surface)) {
            text += fmt::format(", {} x {} poles", spline->count_u(), spline->count_v());
        }
    }
    return text;
}

/// What is most out of tolerance, where it is none of the figures that are told anyway.
std::string worst_of(const Judgement& verdict) {
    if (verdict.within()) {
        return {};
    }
    const Finding& worst = verdict.findings.front();
    for (const FindingKind told : {FindingKind::Gap, FindingKind::Angle, FindingKind::Curvature}) {
        if (worst.kind == told) {
            return {};
        }
    }
    Finding anywhere;
    anywhere.kind = worst.kind;
    anywhere.value = worst.value;
    anywhere.limit = worst.limit;
    return to_text(anywhere) + "; ";
}

/// One sentence on a candidate: "occt: 1.5 times the tolerance (gap ...)".
std::string sentence(const std::string& name, const Judgement& verdict, const FillResult& fill,
                     const FillMeasures& measures) {
    if (verdict.severity == Severity::Bad) {
        return fmt::format("{}: {}", name, to_text(verdict.findings.front()));
    }
    const std::string what = verdict.within()
                                 ? "within tolerance"
                                 : fmt::format("{:.3g} times the tolerance", verdict.score);
    return fmt::format("{}: {} ({}{})", name, what, worst_of(verdict), figures(fill, measures));
}

/// Candidates for one hole, one after the other, and the best of them.
class Contest {
  public:
    Contest(const Site& site, const Hole& hole, const FillRequest& request,
            const Tolerance& tolerance)
        : site_(site),
          hole_(hole),
          request_(request),
          tolerance_(tolerance),
          automatic_(request.method == "auto"),
          asked_(asked_of(site.loops, hole, {}, tolerance)),
          less_(asked_of(site.loops, with_own_wishes_given_up(hole, request), {}, tolerance)),
          unhoped_(asked_of(site.loops, without_hopes(hole, request), {}, tolerance)) {}

    Result<Choice> run(Tries tries) {
        return contest(
            [&](const Attempt& attempt) { return tries == Tries::All || !attempt.slow; });
    }

    /// With what is left after this.
    Result<Choice> go_on(Result<Choice> earlier, Left left) {
        if (earlier) {
            verdicts_.push_back(earlier->reason);
            seconds_ = earlier->seconds;
            best_ = std::move(*earlier);
        } else {
            verdicts_.push_back(earlier.error().message);
        }
        return contest([&](const Attempt& attempt) {
            return left == Left::Slow ? attempt.slow : attempt.improving;
        });
    }

  private:
    template <class TakesPart>
    Result<Choice> contest(const TakesPart& takes_part) {
        for (const Attempt& attempt : attempts_for(site_, hole_, request_, tolerance_)) {
            if (request_.progress.cancelled()) {
                return fail(ErrorCode::Cancelled, "stopped while filling");
            }
            const bool bad = best_ && best_->verdict.severity == Severity::Bad;
            if (best_ && (best_->verdict.within() || (!automatic_ && !bad))) {
                break;
            }
            if (!takes_part(attempt)) {
                continue;
            }
            if (std::ranges::find(site_.spoilt, attempt.name) != site_.spoilt.end()) {
                verdicts_.push_back(attempt.name + ": worse in the written file");
            } else if (worthwhile(attempt, best_, automatic_)) {
                enter(attempt);
            } else if (automatic_ && !attempt.last_resort) {
                verdicts_.push_back(attempt.name + ": not tried");
            }
        }
        if (!best_) {
            return fail(ErrorCode::Refused, "{}", fmt::join(verdicts_, "; "));
        }
        best_->seconds = seconds_;
        const bool as_asked = !automatic_ && verdicts_.size() == 1;
        best_->reason = as_asked ? "as asked" : fmt::format("{}", fmt::join(verdicts_, "; "));
        return std::move(*best_);
    }

    /// Of what is recognised, the next one as well where one is bad.
    void enter(const Attempt& attempt) {
        bool bad = true;
        for (int passed_over = 0; bad && passed_over < kRecognised; ++passed_over) {
            auto choice = tried(attempt, passed_over);
            if (!choice) {
                if (passed_over == 0) {
                    verdicts_.push_back(attempt.name + ": " + choice.error().message);
                }
                return;
            }
            verdicts_.push_back(
                sentence(attempt.name, choice->verdict, choice->fill, choice->measures));
            bad = choice->recognised && choice->verdict.severity == Severity::Bad;
            if (leads(choice->verdict)) {
                best_ = std::move(*choice);
            }
        }
    }

    /// Input    passed_over: as in Attempt::fill.
    Result<Choice> tried(const Attempt& attempt, int passed_over) {
        const auto start = Clock::now();
        Choice choice;
        choice.method = attempt.name;
        choice.relaxed = attempt.last_resort;
        auto fill = attempt.fill(choice.recognised, passed_over);
        seconds_ += std::chrono::duration<double>(Clock::now() - start).count();
        if (!fill) {
            return tl::unexpected(fill.error());
        }
        choice.fill = std::move(*fill);
        auto trial = try_fill(site_, hole_, choice.fill, tolerance_, request_.progress);
        if (!trial) {
            return tl::unexpected(trial.error());
        }
        const bool recognised = choice.recognised.has_value();
        AskedFill wanted = attempt.last_resort ? less_ : recognised ? unhoped_ : asked_;
        account_for(choice.fill, recognised, {}, wanted);
        choice.verdict = judge_fill(wanted, trial->measures);
        if (!choice.verdict.within() && recognised && choice.recognised->twin) {
            choice.twin = measure_twin(site_, hole_, *choice.recognised->twin, request_.progress);
            account_for(choice.fill, recognised, choice.twin, wanted);
            choice.verdict = judge_fill(wanted, trial->measures);
        }
        // Clashes take longest: they are looked for where all else is good enough to be taken.
        if (choice.verdict.severity != Severity::Bad && leads(choice.verdict)) {
            if (auto done = add_clashes(site_, hole_, tolerance_, request_.progress, *trial);
                !done) {
                return tl::unexpected(done.error());
            }
            choice.verdict = judge_fill(wanted, trial->measures);
        }
        choice.measures = std::move(trial->measures);
        choice.placements = std::move(trial->placements);
        return choice;
    }

    [[nodiscard]] bool leads(const Judgement& verdict) const {
        return !best_ || rank_of(verdict) < rank_of(best_->verdict);
    }

    const Site& site_;
    const Hole& hole_;
    const FillRequest& request_;
    const Tolerance& tolerance_;
    bool automatic_;
    AskedFill asked_, less_, unhoped_;
    std::optional<Choice> best_;
    std::vector<std::string> verdicts_;
    double seconds_ = 0.0;
};

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
    return Contest(site, hole, request, tolerance).run(tries);
}

Result<Choice> choose_further(const Site& site, const Hole& hole, const FillRequest& request,
                              const Tolerance& tolerance, Result<Choice> earlier, Left left) {
    return Contest(site, hole, request, tolerance).go_on(std::move(earlier), left);
}

}  // namespace suture

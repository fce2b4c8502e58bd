#include "suture/fill/recognise.h"

#include "suture/base/contract.h"
#include "suture/base/tolerance.h"
#include "suture/fill/extend/trimmed.h"
#include "suture/fill/recognise/border.h"
#include "suture/fill/recognise/describe.h"
#include "suture/fill/recognise/propose.h"

#include <algorithm>
#include <cmath>

namespace suture {
namespace {

using recognise::alike;
using recognise::Border;
using recognise::Proposal;
using recognise::Refusals;

/// A simpler kind is taken if its gap is at most so many times the best one.
constexpr double kSimpler = 1.5;

bool position_only(const Hole& hole) {
    return std::all_of(hole.loops.begin(), hole.loops.end(), [](const RibbonLoop& loop) {
        return std::all_of(loop.ribbons.begin(), loop.ribbons.end(), [](const Ribbon& ribbon) {
            return ribbon.continuity == Continuity::G0;
        });
    });
}

/// Everything that is believed, what is to be taken first: a face's own surface, simple kinds,
/// moved surfaces, balls; those whose gaps are alike before all others.
std::vector<Proposal> proposals_for(const Border& border, const Hole& hole,
                                    const FillOptions& options, Refusals& refusals) {
    std::vector<Proposal> proposals;
    double least = INFINITY;
    const auto add = [&](Proposal proposal) {
        least = std::min(least, proposal.agreement.gap);
        proposals.push_back(std::move(proposal));
    };
    const bool position = position_only(hole);
    const bool circles = position && hole.loops.size() == 2;
    // The rim of a pipe, to which a ball is tangent all around.
    const bool lid = position && !circles && recognise::is_flat(border);
    if (!lid) {
        for (Proposal& form : recognise::propose_forms(border, !circles, refusals)) {
            add(std::move(form));
        }
    }
    if (least > alike(border)) {
        for (Proposal& candidate : recognise::propose_candidates(border, options, refusals)) {
            const bool own = candidate.kind == recognise::kSameSurface;
            add(std::move(candidate));
            if (own) {
                std::rotate(proposals.begin(), proposals.end() - 1, proposals.end());
            }
        }
    }
    if (least > alike(border) && !lid && !circles) {
        for (Proposal& ball : recognise::propose_balls(border, refusals)) {
            add(std::move(ball));
        }
    }
    if (options.prefer == Prefer::Original) {
        std::stable_partition(proposals.begin(), proposals.end(),
                              [](const Proposal& p) { return !p.kind.empty(); });
        return proposals;
    }
    const double enough = kSimpler * std::max(least, alike(border));
    std::stable_partition(proposals.begin(), proposals.end(),
                          [&](const Proposal& p) { return p.agreement.gap <= enough; });
    return proposals;
}

/// Whether the hole, which lies on the left of its loops, is seen from the back of the surface:
/// where no side is tangent, its area in (u, v) tells.
bool runs_against(const Surface& surface, const Hole& hole) {
    constexpr int kSamples = 32;
    double area = 0.0;
    for (const RibbonLoop& loop : hole.loops) {
        for (const Ribbon& ribbon : loop.ribbons) {
            Eigen::Vector2d from = parameters_of(surface, ribbon.at(0.0).point);
            for (int k = 1; k <= kSamples; ++k) {
                const Eigen::Vector2d to =
                    parameters_of(surface, ribbon.at(static_cast<double>(k) / kSamples).point);
                const double along = to.x() - from.x();
                area -= 0.5 * (from.y() + to.y()) *
                        (periodic_u(surface) ? std::remainder(along, 2.0 * kPi) : along);
                from = to;
            }
        }
    }
    return area < 0.0;
}

bool is_reversed(const Proposal& proposal, const Hole& hole) {
    const bool tangent = proposal.agreement.outward + proposal.agreement.inward > 0;
    return tangent || std::holds_alternative<SplineSurface>(proposal.surface)
               ? proposal.agreement.reversed()
               : runs_against(proposal.surface, hole);
}

Result<FillResult> deliver(const Proposal& proposal, const Hole& hole, const FillOptions& options) {
    auto result = extend::trimmed(proposal.surface, proposal.locate, is_reversed(proposal, hole),
                                  hole, options.tolerance.linear);
    if (!result) {
        return result;
    }
    Patch& patch = result->patches.front();
    patch.original = proposal.original;
    patch.exact = proposal.fit_error == 0.0;
    patch.fit_error = proposal.fit_error;
    result->notes.push_back("recognised: " +
                            recognise::sentence(proposal.what, proposal.agreement, proposal.facts));
    return result;
}

}  // namespace

Result<FillResult> fill_recognise(const Hole& hole, const FillOptions& options) {
    SUTURE_EXPECTS(!hole.loops.empty() && !hole.loops.front().ribbons.empty());
    const Border border = recognise::border_of(hole, options.noise, options.side_noise);
    Refusals refusals;
    int passed = 0;
    for (const Proposal& proposal : proposals_for(border, hole, options, refusals)) {
        auto result = deliver(proposal, hole, options);
        if (!result) {
            refusals.add(proposal.what.kind, result.error().message);
        } else if (passed < options.passed_over) {
            ++passed;
            refusals.add(proposal.what.from, "bad where it was tried");
        } else {
            if (options.recognised) {
                options.recognised(proposal.what);
            }
            return result;
        }
    }
    if (refusals.text().empty()) {
        return fail(ErrorCode::Refused,
                    "only position is asked for along a flat rim: it has a lid, and normals say "
                    "nothing");
    }
    return fail(ErrorCode::Refused, "no surface is recognised: {}", refusals.text());
}

}  // namespace suture

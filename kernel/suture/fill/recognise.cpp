#include "suture/fill/recognise.h"

#include "suture/base/contract.h"
#include "suture/fill/extend/trimmed.h"
#include "suture/fill/recognise/agreement.h"
#include "suture/fill/recognise/ball.h"
#include "suture/fill/recognise/border.h"
#include "suture/fill/recognise/describe.h"
#include "suture/fill/recognise/form.h"
#include "suture/fill/recognise/plain.h"
#include "suture/fill/recognise/refine.h"
#include "suture/fill/recognise/starts.h"
#include "suture/fill/recognise/surface_foot.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>

namespace suture {
namespace {

using recognise::Agreement;
using recognise::Border;

/// A surface on which the hole may lie, and how well it does.
struct Proposal {
    Surface surface;        ///< in model units
    extend::Locate locate;  ///< of a B-spline
    Agreement agreement;
    recognise::Recognised what;
    std::vector<std::string> facts;
    double fit_error = 0.0;  ///< of a ball's envelope
};

/// A closed form in the border's coordinates, and how well it fits.
struct Form {
    Surface form;
    Agreement agreement;
};

/// Starts of a kind that are refined: the nearest ones.
constexpr std::size_t kRefined = 4;

/// A start further off than this share of the hole's size leads nowhere.
constexpr double kHopelessStart = 0.1;

/// Gaps, as shares of the hole's diameter, that do not tell one kind from another: what rounding
/// leaves in a file.
constexpr double kAlike = 1e-8;

/// Pairs of sides between which a ball is tried.
constexpr std::size_t kBalls = 3;

/// How near a ball's envelope is fitted, as a share of the hole's diameter.
constexpr double kArcError = 1e-8;

/// A simpler kind is taken if its gap is at most so many times the best one.
constexpr double kSimpler = 1.5;

bool position_only(const Hole& hole) {
    return std::all_of(hole.loops.begin(), hole.loops.end(), [](const RibbonLoop& loop) {
        return std::all_of(loop.ribbons.begin(), loop.ribbons.end(), [](const Ribbon& ribbon) {
            return ribbon.continuity == Continuity::G0;
        });
    });
}

/// The best believed form of a kind; else why the best one is not believed.
Result<Form> best_of(const std::vector<Surface>& starts, const Border& border,
                     recognise::Evidence evidence = recognise::Evidence::Fit) {
    std::vector<std::pair<double, const Surface*>> order;
    for (const Surface& start : starts) {
        const double off = recognise::rms(start, border);
        if (off < kHopelessStart) {
            order.emplace_back(off, &start);
        }
    }
    const std::size_t count = std::min(kRefined, order.size());
    std::partial_sort(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(count),
                      order.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    std::optional<Form> best;
    std::optional<Error> why;
    for (std::size_t k = 0; k < count; ++k) {
        const Surface form = recognise::refine(*order[k].second, border);
        if (!recognise::sensible(form)) {
            continue;
        }
        const Agreement agreement = recognise::measure(form, border);
        if (const auto believed = recognise::believe(agreement, border, evidence); !believed) {
            why = why ? why : believed.error();
            continue;
        }
        if (!best || agreement.gap < best->agreement.gap) {
            best = Form{form, agreement};
        }
        if (best->agreement.gap < kAlike) {
            break;
        }
    }
    if (best) {
        return *best;
    }
    return why ? tl::unexpected(*why) : fail(ErrorCode::Refused, "no fit");
}

void add_refusal(const std::string& what, const std::string& why, std::string& refusals) {
    refusals += fmt::format("{}{}: {}", refusals.empty() ? "" : "; ", what, why);
}

/// The believed closed forms, the simplest kind first.
std::vector<Form> forms_for(const Border& border, std::string& refusals) {
    const recognise::Starts starts = recognise::starts_for(border);
    std::vector<Form> forms;
    constexpr const char* kNames[] = {"plane", "sphere", "cylinder", "cone", "torus"};
    for (std::size_t kind = 0; kind < starts.size(); ++kind) {
        const auto found = best_of(starts[kind], border);
        if (!found) {
            add_refusal(kNames[kind], found.error().message, refusals);
            continue;
        }
        forms.push_back(*found);
        if (found->agreement.gap < kAlike) {
            break;  // no other kind can be better
        }
    }
    return forms;
}

/// Two circles about one axis, of which only the position is known: the cylinder between them, or
/// the cone.
std::vector<Form> between_circles(const Border& border, std::string& refusals) {
    const recognise::Starts starts = recognise::starts_for(border);
    std::vector<Form> forms;
    for (const std::size_t kind : {2, 3}) {
        const auto found = best_of(starts[kind], border, recognise::Evidence::Model);
        if (found) {
            forms.push_back(*found);
            break;
        }
        add_refusal(kind == 2 ? "cylinder" : "cone", found.error().message, refusals);
    }
    return forms;
}

Proposal proposal_for(const Form& found, const Border& border) {
    recognise::PlainForm plain = recognise::plain(found.form, border);
    Agreement agreement = recognise::measure(plain.form, border);
    if (!recognise::believe(agreement, border)) {
        plain = {found.form, {}};
        agreement = found.agreement;
    }
    const Surface surface = border.to_model(plain.form);
    return {surface, {}, agreement, recognise::describe(surface), std::move(plain.facts)};
}

/// The envelopes of rolling balls that are believed.
std::vector<Proposal> balls_for(const Border& border, const Hole& hole, std::string& refusals) {
    std::vector<Proposal> proposals;
    const std::vector<recognise::BallGuess> guesses = recognise::guess_balls(border);
    for (std::size_t k = 0; k < std::min(kBalls, guesses.size()); ++k) {
        for (const double radius : recognise::radii_for(guesses[k], border)) {
            const auto arcs =
                recognise::ball_surface(guesses[k], radius, border, kArcError * hole.diameter);
            if (!arcs) {
                add_refusal("rolling ball", arcs.error().message, refusals);
                continue;
            }
            const auto foot = std::make_shared<const recognise::SurfaceFoot>(arcs->surface);
            const Agreement agreement = recognise::measure(
                [&](const Eigen::Vector3d& point) { return foot->foot(point); }, border);
            if (const auto believed = recognise::believe(agreement, border); !believed) {
                add_refusal("rolling ball", believed.error().message, refusals);
                continue;
            }
            const auto locate = [foot](const Ribbon& ribbon, double s) {
                return foot->find(ribbon.at(s).point);
            };
            proposals.push_back({arcs->surface,
                                 locate,
                                 agreement,
                                 recognise::describe_ball(std::abs(radius)),
                                 {},
                                 arcs->error});
            break;
        }
        if (!proposals.empty() && proposals.back().agreement.gap < kAlike) {
            break;
        }
    }
    return proposals;
}

/// Everything that is believed, what is to be taken first: simple kinds, balls; those whose gaps
/// are alike before all others.
std::vector<Proposal> proposals_for(const Border& border, const Hole& hole, std::string& refusals) {
    std::vector<Proposal> proposals;
    double least = INFINITY;
    const auto add = [&](Proposal proposal) {
        least = std::min(least, proposal.agreement.gap);
        proposals.push_back(std::move(proposal));
    };
    const bool position = position_only(hole);
    for (const Form& form :
         position ? between_circles(border, refusals) : forms_for(border, refusals)) {
        add(proposal_for(form, border));
    }
    if (position) {
        return proposals;
    }
    if (least > kAlike) {
        for (Proposal& ball : balls_for(border, hole, refusals)) {
            add(std::move(ball));
        }
    }
    const double enough = kSimpler * std::max(least, kAlike);
    std::stable_partition(proposals.begin(), proposals.end(),
                          [&](const Proposal& p) { return p.agreement.gap <= enough; });
    return proposals;
}

Result<FillResult> deliver(const Proposal& proposal, const Hole& hole, double distance) {
    auto result = extend::trimmed(proposal.surface, proposal.locate, proposal.agreement.reversed(),
                                  hole, distance);
    if (!result) {
        return result;
    }
    Patch& patch = result->patches.front();
    patch.exact = proposal.fit_error == 0.0;
    patch.fit_error = proposal.fit_error;
    result->notes.push_back("recognised: " +
                            recognise::sentence(proposal.what, proposal.agreement, proposal.facts));
    return result;
}

}  // namespace

Result<FillResult> fill_recognise(const Hole& hole, const FillOptions& options) {
    SUTURE_EXPECTS(!hole.loops.empty() && !hole.loops.front().ribbons.empty());
    if (position_only(hole) && hole.loops.size() != 2) {
        return fail(ErrorCode::Refused,
                    "only position is asked for: normals, which tell the lost face, say nothing");
    }
    const Border border = recognise::border_of(hole);
    std::string refusals;
    for (const Proposal& proposal : proposals_for(border, hole, refusals)) {
        auto result = deliver(proposal, hole, options.tolerance.linear);
        if (result) {
            return result;
        }
        add_refusal(proposal.what.kind, result.error().message, refusals);
    }
    return fail(ErrorCode::Refused, "no surface is recognised: {}", refusals);
}

}  // namespace suture

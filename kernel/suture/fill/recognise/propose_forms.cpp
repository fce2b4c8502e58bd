#include "suture/fill/recognise/describe.h"
#include "suture/fill/recognise/form.h"
#include "suture/fill/recognise/plain.h"
#include "suture/fill/recognise/propose.h"
#include "suture/fill/recognise/refine.h"
#include "suture/fill/recognise/starts.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace suture::recognise {
namespace {

constexpr const char* kNames[] = {"plane", "sphere", "cylinder", "cone", "torus"};

/// A closed form in the border's coordinates, and how well it fits.
struct Form {
    PlainForm plain;
    Agreement agreement;
};

/// Starts of a kind that are refined: the nearest ones.
constexpr std::size_t kRefined = 4;

/// A start further off than this share of the hole's size leads nowhere.
constexpr double kHopelessStart = 0.1;

/// Fits whose border lies off by so many times the largest gap are not looked at any more.
constexpr double kHopeless = 3.0;

/// Gaps, as shares of the hole's diameter, that do not tell one kind from another: to this a ball's
/// envelope is fitted.
constexpr double kAlike = 1e-8;

/// A form with the numbers that are believed, plain ones first.
Result<Form> believed_form(const Surface& form, const Border& border, const Border& exact,
                           Evidence evidence) {
    if (const double gap = measure(form, border).gap; gap > kHopeless * largest_gap(border)) {
        return fail(ErrorCode::Refused, "the border lies off by {:.2g} of the hole's diameter",
                    gap);
    }
    Form round{plain(form, exact), {}};
    round.agreement = measure(round.plain.form, border);
    evidence.chance = round.plain.chance;
    if (believe(round.agreement, border, evidence)) {
        return round;
    }
    evidence.chance = 1.0;
    Form as_fitted{{form, {}}, measure(form, border)};
    if (const auto believed = believe(as_fitted.agreement, border, evidence); !believed) {
        return tl::unexpected(believed.error());
    }
    return as_fitted;
}

/// The best believed form of a kind; else why the best one is not believed.
///
/// Input    exact: the border without its rough sides.
Result<Form> best_of(const std::vector<Surface>& starts, const Border& border, const Border& exact,
                     const Evidence& evidence = {}) {
    std::vector<std::pair<double, const Surface*>> order;
    for (const Surface& start : starts) {
        const double off = rms(start, exact);
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
        const Surface form = refine(*order[k].second, exact);
        if (!sensible(form)) {
            continue;
        }
        auto believed = believed_form(form, border, exact, evidence);
        if (!believed) {
            why = why ? why : believed.error();
            continue;
        }
        if (!best || believed->agreement.gap < best->agreement.gap) {
            best = std::move(*believed);
        }
        if (best->agreement.gap <= alike(border)) {
            break;
        }
    }
    if (best) {
        return *best;
    }
    return why ? tl::unexpected(*why) : fail(ErrorCode::Refused, "no fit");
}

/// The believed closed forms, the simplest kind first.
std::vector<Form> forms_for(const Border& border, Refusals& refusals) {
    const Border exact = exact_part(border);
    const Starts starts = starts_for(exact);
    std::vector<Form> forms;
    for (std::size_t kind = 0; kind < starts.size(); ++kind) {
        const auto found = best_of(starts[kind], border, exact);
        if (!found) {
            refusals.add(kNames[kind], found.error().message);
            continue;
        }
        forms.push_back(*found);
        if (found->agreement.gap <= alike(border)) {
            break;  // no other kind can be better
        }
    }
    return forms;
}

/// The cylinder or the cone between two rims, to which the neighbours' normals say nothing.
std::vector<Form> between_rims(const Border& border, std::size_t kind, Refusals& refusals) {
    const auto found = best_of(rim_starts(border)[kind], border, border, {/*of_model=*/true});
    if (!found) {
        refusals.add(fmt::format("{} between the rims", kNames[kind]), found.error().message);
        return {};
    }
    return {*found};
}

Proposal proposal_for(const Form& found, const Border& border) {
    const Surface surface = border.to_model(found.plain.form);
    return {surface,
            {},
            found.agreement,
            describe(surface, found.agreement, border),
            found.plain.facts};
}

}  // namespace

double alike(const Border& border) {
    return std::max(kAlike, border.noise);
}

void Refusals::add(const std::string& what, const std::string& why) {
    text_ += fmt::format("{}{}: {}", text_.empty() ? "" : "; ", what, why);
}

std::vector<Proposal> propose_forms(const Border& border, bool by_normals, Refusals& refusals) {
    constexpr std::size_t kCylinder = 2;
    constexpr std::size_t kCone = 3;
    const bool rims = border.sides.back().loop == 1;
    std::vector<Form> forms;
    if (rims) {
        forms = between_rims(border, kCylinder, refusals);
    }
    if (by_normals && forms.empty()) {
        forms = forms_for(border, refusals);
    }
    if (rims && forms.empty()) {
        forms = between_rims(border, kCone, refusals);
    }
    std::vector<Proposal> proposals;
    proposals.reserve(forms.size());
    for (const Form& form : forms) {
        proposals.push_back(proposal_for(form, border));
    }
    return proposals;
}

}  // namespace suture::recognise

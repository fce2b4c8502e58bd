#include "suture/flow/plan.h"

#include "suture/candidates/model_candidates.h"
#include "suture/choose/choose.h"
#include "suture/choose/select.h"
#include "suture/detect/find_loops.h"
#include "suture/edges/chain.h"
#include "suture/edges/split.h"
#include "suture/ribbon/extract.h"
#include "suture/ribbon/facets.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <memory>
#include <mutex>
#include <set>

namespace suture {
namespace {

/// Whether everything in a request can be asked for.
Result<void> validate(const FillRequest& request) {
    for (auto& valid :
         {validate(request.tolerance), validate_method(request.method),
          validate_options(request.method, options_of(request.method), request.options)}) {
        if (!valid) {
            return valid;
        }
    }
    return {};
}

/// What every ribbon should do, as the wishes have it.
void ask(Hole& hole, const std::vector<Wish>& wishes) {
    std::size_t next = 0;
    for (RibbonLoop& loop : hole.loops) {
        for (Ribbon& ribbon : loop.ribbons) {
            ribbon.continuity = wishes[next++].continuity;
        }
    }
}

bool is_left_open(const std::vector<BoundaryLoop>& loops, const FillRequest& request) {
    return std::any_of(request.leave_open.begin(), request.leave_open.end(),
                       [&](int id) { return id == loops.front().id; });
}

/// The search for surfaces of the model, made once.
CandidateFinder candidates_for(const TopoDS_Shape& shape, const occ::Numbering& numbering,
                               const std::vector<BoundaryLoop>& loops, const Hole& hole,
                               Scope scope) {
    struct Found {
        std::once_flag once;
        std::vector<Candidate> candidates;
    };
    return [shape, &numbering, loops, hole, scope, found = std::make_shared<Found>()] {
        std::call_once(found->once, [&] {
            // Where the search fails there is one source less: no reason to refuse the hole.
            found->candidates = find_candidates(shape, numbering, loops, hole, scope)
                                    .value_or(std::vector<Candidate>());
        });
        return found->candidates;
    };
}

/// Position only, for no face is tangent to facets; but through points of what they mean.
void ask_to_follow_facets(const TopoDS_Shape& shape, HolePlan& plan) {
    const auto points = points_between_facets(shape, plan.loops, *plan.hole);
    if (points.empty()) {
        return;
    }
    plan.guides = points.size();
    for (const Eigen::Vector3d& point : points) {
        plan.hole->through.push_back({point});
    }
    plan.wishes.assign(plan.wishes.size(),
                       Wish{Continuity::G0,
                            "auto: position only, the neighbours are facets; the face follows the "
                            "curved shape that they mean"});
    ask(*plan.hole, plan.wishes);
}

HolePlan plan_of(const TopoDS_Shape& shape, const occ::Numbering& numbering,
                 const std::vector<BoundaryLoop>& loops, const FillRequest& request) {
    if (is_left_open(loops, request)) {
        return {loops, fail(ErrorCode::Refused, "left open"), {}, {}, 0, {}};
    }
    HolePlan plan{loops, extract_hole(loops), {}, {}, 0, {}};
    if (plan.hole) {
        plan.hole->through = request.through;
        if (const auto spoilt = request.spoilt.find(loops.front().id);
            spoilt != request.spoilt.end()) {
            plan.spoilt = spoilt->second;
        }
        plan.wishes = wishes_for(*plan.hole, request);
        ask(*plan.hole, plan.wishes);
        // Borders between facets leave their planes; what they mean is smooth all the same.
        const auto ours = [](const Wish& wish) { return wish.own || wish.sharp; };
        if (std::ranges::all_of(plan.wishes, ours) && are_facets(*plan.hole, loops)) {
            ask_to_follow_facets(shape, plan);
        }
        if (request.recognise) {
            plan.candidates =
                candidates_for(shape, numbering, loops, *plan.hole, *request.recognise);
        }
    }
    return plan;
}

/// One hole for each boundary that was chosen edge by edge; the loops that are no part of any are
/// left alone.
Result<Selection> select_boundaries(const TopoDS_Shape& shape, const occ::Numbering& numbering,
                                    const std::vector<BoundaryLoop>& loops,
                                    const FillRequest& request) {
    Selection selection;
    std::set<int> taken;
    int id = std::max(static_cast<int>(loops.size()), request.first_new_id - 1);
    for (const std::vector<int>& edges : request.boundaries) {
        auto chained = chain_edges(shape, numbering, loops,
                                   {edges, request.reach, request.connect, request.bridge,
                                    request.supports, request.tension});
        if (!chained) {
            return tl::unexpected(chained.error());
        }
        for (BoundaryLoop& loop : *chained) {
            if (loop.id > static_cast<int>(loops.size())) {
                loop.id = ++id;
            }
            if (!taken.insert(loop.id).second) {
                return fail(ErrorCode::Usage, "the edges {} are chosen for two faces",
                            fmt::join(edges, ", "));
            }
        }
        selection.holes.push_back(std::move(*chained));
    }
    for (const BoundaryLoop& loop : loops) {
        if (!taken.contains(loop.id)) {
            selection.skipped.push_back(skipped_report(loop));
        }
    }
    return selection;
}

/// Where a hole is to be cut in two.
///
/// Input    used: which of request.splits have met their hole; one more may be marked.
std::optional<CornerPair> split_of(const std::vector<BoundaryLoop>& hole,
                                   const FillRequest& request, std::vector<bool>& used) {
    if (hole.size() != 1) {
        return std::nullopt;  // with an island there are no two sides of the line
    }
    for (std::size_t i = 0; i < request.splits.size(); ++i) {
        const auto& [one, other] = request.splits[i];
        const double reach = std::max(request.reach, request.tolerance.linear);
        if (auto corners = corners_at(hole.front(), one, other, reach); corners && !used[i]) {
            used[i] = true;
            return corners;
        }
    }
    return request.split_sharp ? find_split(hole.front()) : std::nullopt;
}

/// Cuts the holes that are to get two faces. A part may be cut again.
Result<void> split_holes(const FillRequest& request, int first_free_id, Selection& selection) {
    std::vector<bool> used(request.splits.size(), false);
    int id = first_free_id;
    for (std::size_t i = 0; i < selection.holes.size();) {
        const auto corners = split_of(selection.holes[i], request, used);
        if (!corners) {
            ++i;
            continue;
        }
        auto parts = split_loop(selection.holes[i].front(), *corners);
        if (!parts) {
            return tl::unexpected(parts.error());
        }
        parts->second.id = id++;
        selection.holes[i] = {std::move(parts->first)};
        const auto place = selection.holes.begin() + static_cast<std::ptrdiff_t>(i) + 1;
        selection.holes.insert(place, std::vector<BoundaryLoop>{std::move(parts->second)});
    }
    if (const auto lost = std::ranges::find(used, false); lost != used.end()) {
        return fail(ErrorCode::Usage,
                    "--split: none of the chosen holes has a corner at both vertices of pair {}",
                    lost - used.begin() + 1);
    }
    return {};
}

/// An id that no loop of the shape and no boundary has.
int first_free_id(const std::vector<BoundaryLoop>& loops, const Selection& selection,
                  const FillRequest& request) {
    int last = std::max(static_cast<int>(loops.size()), request.first_new_id - 1);
    for (const std::vector<BoundaryLoop>& hole : selection.holes) {
        for (const BoundaryLoop& loop : hole) {
            last = std::max(last, loop.id);
        }
    }
    return last + 1;
}

}  // namespace

Result<FillPlan> plan_fills(const TopoDS_Shape& shape, const occ::Numbering& numbering,
                            const FillRequest& request) {
    if (auto valid = validate(request); !valid) {
        return tl::unexpected(valid.error());
    }
    const auto loops = find_loops(shape, numbering);
    if (!loops) {
        return tl::unexpected(loops.error());
    }
    auto selection = request.boundaries.empty()
                         ? select_holes(*loops, request)
                         : select_boundaries(shape, numbering, *loops, request);
    if (!selection) {
        return tl::unexpected(selection.error());
    }
    if (auto split = split_holes(request, first_free_id(*loops, *selection, request), *selection);
        !split) {
        return tl::unexpected(split.error());
    }
    if (!request.through.empty() && selection->holes.size() != 1) {
        return fail(ErrorCode::Usage,
                    "points to pass through belong to one hole, not to {}: choose it with --hole",
                    selection->holes.size());
    }
    FillPlan plan{{}, selection->skipped, &numbering};
    for (const std::vector<BoundaryLoop>& hole : selection->holes) {
        plan.holes.push_back(plan_of(shape, numbering, hole, request));
    }
    return plan;
}

}  // namespace suture

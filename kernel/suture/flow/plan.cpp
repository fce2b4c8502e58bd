#include "suture/flow/plan.h"

#include "suture/candidates/model_candidates.h"
#include "suture/choose/choose.h"
#include "suture/choose/select.h"
#include "suture/detect/find_loops.h"
#include "suture/edges/chain.h"
#include "suture/ribbon/extract.h"

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

HolePlan plan_of(const TopoDS_Shape& shape, const occ::Numbering& numbering,
                 const std::vector<BoundaryLoop>& loops, const FillRequest& request) {
    if (is_left_open(loops, request)) {
        return {loops, fail(ErrorCode::Refused, "left open"), {}, {}};
    }
    HolePlan plan{loops, extract_hole(loops), {}, {}};
    if (plan.hole) {
        plan.hole->through = request.through;
        plan.wishes = wishes_for(*plan.hole, request);
        ask(*plan.hole, plan.wishes);
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
                                   {edges, request.reach, request.connect, request.bridge});
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
    const auto selection = request.boundaries.empty()
                               ? select_holes(*loops, request)
                               : select_boundaries(shape, numbering, *loops, request);
    if (!selection) {
        return tl::unexpected(selection.error());
    }
    if (!request.through.empty() && selection->holes.size() != 1) {
        return fail(ErrorCode::Usage,
                    "points to pass through belong to one hole, not to {}: choose it with --hole",
                    selection->holes.size());
    }
    FillPlan plan{{}, selection->skipped};
    for (const std::vector<BoundaryLoop>& hole : selection->holes) {
        plan.holes.push_back(plan_of(shape, numbering, hole, request));
    }
    return plan;
}

}  // namespace suture

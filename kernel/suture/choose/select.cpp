#include "suture/choose/select.h"

#include <algorithm>
#include <set>
#include <utility>

namespace suture {
namespace {

const BoundaryLoop* find_id(const std::vector<BoundaryLoop>& loops, int id) {
    const auto it = std::find_if(loops.begin(), loops.end(),
                                 [&](const BoundaryLoop& loop) { return loop.id == id; });
    return it == loops.end() ? nullptr : &*it;
}

bool contains_edge(const BoundaryLoop& loop, int edge) {
    return std::any_of(loop.edges.begin(), loop.edges.end(),
                       [&](const BoundaryEdge& e) { return e.edge_number == edge; });
}

/// A loop with the islands that detection found to bound the same missing face.
std::vector<int> with_islands(const BoundaryLoop& loop) {
    std::vector<int> ids = {loop.id};
    ids.insert(ids.end(), loop.islands_with.begin(), loop.islands_with.end());
    return ids;
}

Result<std::vector<std::vector<int>>> named(const std::vector<BoundaryLoop>& loops,
                                            const FillRequest& request) {
    std::vector<std::vector<int>> groups;
    for (const std::vector<int>& ids : request.holes) {
        for (const int id : ids) {
            if (find_id(loops, id) == nullptr) {
                return fail(ErrorCode::Usage, "there is no hole {}: the model's loops are 1 to {}",
                            id, loops.size());
            }
        }
        groups.push_back(ids.size() == 1 ? with_islands(*find_id(loops, ids.front())) : ids);
    }
    for (const int edge : request.edges) {
        const auto loop = std::find_if(loops.begin(), loops.end(), [&](const BoundaryLoop& l) {
            return contains_edge(l, edge);
        });
        if (loop == loops.end()) {
            return fail(ErrorCode::Usage, "edge {} lies on no boundary loop", edge);
        }
        groups.push_back(with_islands(*loop));
    }
    return groups;
}

bool fillable(LoopKind kind, bool all_loops) {
    return kind == LoopKind::Hole ||
           (all_loops && (kind == LoopKind::Rim || kind == LoopKind::Ambiguous));
}

}  // namespace

HoleReport skipped_report(const BoundaryLoop& loop) {
    HoleReport report;
    report.ids = {loop.id};
    report.status = FillStatus::Skipped;
    report.reason = loop.kind == LoopKind::Hole
                        ? "not asked for"
                        : std::string(to_string(loop.kind)) + ": " + loop.reason;
    return report;
}

Result<Selection> select_holes(const std::vector<BoundaryLoop>& loops, const FillRequest& request) {
    std::vector<std::vector<int>> groups;
    if (request.holes.empty() && request.edges.empty()) {
        for (const BoundaryLoop& loop : loops) {
            if (fillable(loop.kind, request.all_loops)) {
                groups.push_back(with_islands(loop));
            }
        }
    } else {
        auto asked = named(loops, request);
        if (!asked) {
            return tl::unexpected(asked.error());
        }
        groups = std::move(*asked);
    }
    Selection selection;
    std::set<int> taken;
    for (const std::vector<int>& ids : groups) {
        if (taken.contains(ids.front())) {
            continue;  // an island of a hole that is already there
        }
        auto& hole = selection.holes.emplace_back();
        for (const int id : ids) {
            hole.push_back(*find_id(loops, id));
            taken.insert(id);
        }
        // Loops of one length by their ids, however they were named.
        std::ranges::sort(
            hole, {}, [](const BoundaryLoop& loop) { return std::pair(-loop.length, loop.id); });
    }
    for (const BoundaryLoop& loop : loops) {
        if (!taken.contains(loop.id)) {
            selection.skipped.push_back(skipped_report(loop));
        }
    }
    if (selection.holes.empty()) {
        return loops.empty()
                   ? fail(ErrorCode::NothingToDo, "the model has no hole: every shell is closed")
                   : fail(ErrorCode::NothingToDo,
                          "the model has no hole, only {} other boundary loop(s), the first a {} "
                          "({}); --all-loops or --hole fills them",
                          loops.size(), to_string(loops.front().kind), loops.front().reason);
    }
    return selection;
}

}  // namespace suture

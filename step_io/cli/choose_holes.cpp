#include "cli/choose_holes.h"

#include "cli/table.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

namespace suture::cli {
namespace {

bool has_loop(const PartLoops& part, int id) {
    return id > part.ids_before && id <= part.ids_before + static_cast<int>(part.loops.size());
}

bool has_edge(const PartLoops& part, int edge) {
    return std::any_of(part.loops.begin(), part.loops.end(), [&](const BoundaryLoop& loop) {
        return std::any_of(loop.edges.begin(), loop.edges.end(),
                           [&](const BoundaryEdge& side) { return side.edge_number == edge; });
    });
}

template <class Predicate>
std::optional<std::size_t> find_part(const std::vector<PartLoops>& parts, Predicate predicate) {
    const auto found = std::find_if(parts.begin(), parts.end(), predicate);
    if (found == parts.end()) {
        return std::nullopt;
    }
    return static_cast<std::size_t>(found - parts.begin());
}

Result<std::size_t> part_of_hole(int id, const std::vector<PartLoops>& parts) {
    const auto part = find_part(parts, [&](const PartLoops& p) { return has_loop(p, id); });
    if (part) {
        return *part;
    }
    const int count =
        parts.empty() ? 0 : parts.back().ids_before + static_cast<int>(parts.back().loops.size());
    return fail(ErrorCode::Usage, "there is no hole {}: {}; `suture inspect` lists them", id,
                count == 0 ? "the model has no boundary loop"
                           : fmt::format("the boundary loops have the numbers 1 to {}", count));
}

Result<std::size_t> part_of_edge(int edge, const std::vector<PartLoops>& parts,
                                 int edges_in_model) {
    if (edge > edges_in_model) {
        return fail(ErrorCode::Usage, "there is no edge {}: the model has {} edges", edge,
                    edges_in_model);
    }
    const auto part = find_part(parts, [&](const PartLoops& p) { return has_edge(p, edge); });
    if (part) {
        return *part;
    }
    return fail(ErrorCode::Usage,
                "edge {} bounds no hole: two faces share it, or it lies in another instance of its "
                "part; `suture inspect` lists the edges of every hole",
                edge);
}

/// The request without the choice of holes and edges, once per part.
std::vector<PartRequest> empty_requests(const FillRequest& request, std::size_t parts) {
    std::vector<PartRequest> result(parts);
    for (std::size_t i = 0; i < parts; ++i) {
        result[i].part = i;
        result[i].request = request;
        result[i].request.holes.clear();
        result[i].request.edges.clear();
        result[i].request.boundaries.clear();
    }
    return result;
}

/// Whether a loop is filled unasked.
bool is_fillable(const BoundaryLoop& loop, const FillRequest& request) {
    return loop.kind == LoopKind::Hole || (request.all_loops && loop.kind != LoopKind::Seam);
}

bool passes(const HoleFilter& filter, const BoundaryLoop& loop,
            const std::vector<BoundaryLoop>& loops) {
    std::size_t sides = loop.edges.size();
    for (const BoundaryLoop& other : loops) {
        const bool island =
            std::ranges::find(loop.islands_with, other.id) != loop.islands_with.end();
        if (island && other.length > loop.length) {
            return false;  // that of the longest loop speaks for all
        }
        sides += island ? other.edges.size() : 0;
    }
    return (!filter.planar || loop.planar) && (!filter.larger || loop.diameter > *filter.larger) &&
           (!filter.smaller || loop.diameter < *filter.smaller) &&
           (!filter.sides || sides == static_cast<std::size_t>(*filter.sides));
}

/// Without a choice: every part with a loop that is to be filled.
Result<std::vector<PartRequest>> all_holes(const FillRequest& request,
                                           const std::vector<PartLoops>& parts) {
    std::vector<PartRequest> result;
    for (PartRequest& part : empty_requests(request, parts.size())) {
        const auto& loops = parts[part.part].loops;
        if (std::any_of(loops.begin(), loops.end(),
                        [&](const BoundaryLoop& loop) { return is_fillable(loop, request); })) {
            result.push_back(std::move(part));
        }
    }
    if (result.empty()) {
        return fail(ErrorCode::NothingToDo, "the model has no hole{}", what_else(parts));
    }
    return result;
}

/// Each boundary to the part that has its edges.
Result<std::vector<PartRequest>> divide_boundaries(const FillRequest& request,
                                                   const std::vector<PartLoops>& parts) {
    std::vector<occ::Numbering> own;
    for (const PartLoops& part : parts) {
        own.emplace_back(part.part.shape);
    }
    std::vector<PartRequest> result = empty_requests(request, parts.size());
    for (const std::vector<int>& boundary : request.boundaries) {
        const auto part = find_part(parts, [&](const PartLoops& p) {
            return own[static_cast<std::size_t>(&p - parts.data())].edges.Contains(
                p.numbering.edges(boundary.front()));
        });
        if (!part) {
            return fail(ErrorCode::Usage,
                        "edge {} lies in another instance of its part: choose that of the first",
                        boundary.front());
        }
        result[*part].request.boundaries.push_back(boundary);
    }
    std::erase_if(result, [](const PartRequest& part) { return part.request.boundaries.empty(); });
    return result;
}

}  // namespace

std::string what_else(const std::vector<PartLoops>& parts) {
    int rims = 0;
    int seams = 0;
    int others = 0;
    for (const PartLoops& part : parts) {
        for (const BoundaryLoop& loop : part.loops) {
            ++(loop.kind == LoopKind::Rim ? rims : loop.kind == LoopKind::Seam ? seams : others);
        }
    }
    std::string text;
    if (rims > 0) {
        text += fmt::format("; it has {} of open sheets (--all-loops fills them)",
                            counted(rims, "rim"));
    }
    if (seams > 0) {
        text += fmt::format("; it has {} (--sew-tolerance with a larger value may close them)",
                            counted(seams, "unsewn seam"));
    }
    if (others > 0) {
        text += fmt::format("; it has {} (name them with --hole to fill them)",
                            counted(others, "other loop"));
    }
    return text;
}

Result<std::vector<std::vector<int>>> holes_like(const HoleFilter& filter,
                                                 const FillRequest& request,
                                                 const std::vector<PartLoops>& parts) {
    std::vector<std::vector<int>> holes;
    int fillable = 0;
    for (const PartLoops& part : parts) {
        for (const BoundaryLoop& loop : part.loops) {
            if (is_fillable(loop, request)) {
                ++fillable;
                if (passes(filter, loop, part.loops)) {
                    holes.push_back({loop.id});
                }
            }
        }
    }
    if (holes.empty()) {
        return fail(ErrorCode::NothingToDo,
                    "none of the model's {} is as --planar, --larger, --smaller and --sides say{}",
                    counted(fillable, "hole"), what_else(parts));
    }
    return holes;
}

namespace {

/// Borders that were chosen, and parts of holes that are cut in two, have ids behind those of all
/// loops; no two parts of the model the same ones.
void give_new_ids(const FillRequest& request, const std::vector<PartLoops>& parts,
                  std::vector<PartRequest>& requests) {
    std::size_t loops = 0;
    std::size_t edges = 0;
    for (const PartLoops& part : parts) {
        loops += part.loops.size();
        for (const BoundaryLoop& loop : part.loops) {
            edges += loop.edges.size();
        }
    }
    for (const std::vector<int>& boundary : request.boundaries) {
        edges += boundary.size();
    }
    const std::size_t most = 2 * edges;  // a border for each edge, and as many cuts
    for (PartRequest& part : requests) {
        part.request.first_new_id =
            static_cast<int>(loops + 1 + most * part.part) - parts[part.part].ids_before;
    }
}

Result<std::vector<PartRequest>> divided(const FillRequest& request,
                                         const std::vector<PartLoops>& parts, int edges_in_model) {
    for (const auto& [edge, continuity] : request.edge_continuity) {
        const auto part = part_of_edge(edge, parts, edges_in_model);
        if (!part) {
            return tl::unexpected(part.error());
        }
    }
    if (!request.boundaries.empty()) {
        return divide_boundaries(request, parts);
    }
    if (request.holes.empty() && request.edges.empty()) {
        return all_holes(request, parts);
    }
    std::vector<PartRequest> result = empty_requests(request, parts.size());
    for (const std::vector<int>& hole : request.holes) {
        std::vector<int> ids;
        std::optional<std::size_t> common;
        for (const int id : hole) {
            const Result<std::size_t> part = part_of_hole(id, parts);
            if (!part) {
                return tl::unexpected(part.error());
            }
            if (common.value_or(*part) != *part) {
                return fail(ErrorCode::Usage, "loops {} and {} belong to different parts",
                            hole.front(), id);
            }
            common = *part;
            ids.push_back(id - parts[*part].ids_before);
        }
        result[*common].request.holes.push_back(std::move(ids));
    }
    for (const int edge : request.edges) {
        const Result<std::size_t> part = part_of_edge(edge, parts, edges_in_model);
        if (!part) {
            return tl::unexpected(part.error());
        }
        result[*part].request.edges.push_back(edge);
    }
    std::erase_if(result, [](const PartRequest& part) {
        return part.request.holes.empty() && part.request.edges.empty();
    });
    return result;
}

}  // namespace

Result<std::vector<PartRequest>> divide_request(const FillRequest& request,
                                                const std::vector<PartLoops>& parts,
                                                int edges_in_model) {
    return divided(request, parts, edges_in_model).map([&](std::vector<PartRequest>&& requests) {
        give_new_ids(request, parts, requests);
        return std::move(requests);
    });
}

}  // namespace suture::cli

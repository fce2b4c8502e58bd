#include "suture/edges/orient.h"

#include "suture/edges/walk.h"

#include <algorithm>
#include <utility>

namespace suture {
namespace {

bool has_face(const BoundaryLoop& loop) {
    return std::ranges::any_of(loop.edges,
                               [](const BoundaryEdge& side) { return !side.face.IsNull(); });
}

}  // namespace

void begin_at_smallest(BoundaryLoop& loop) {
    const auto smallest = std::ranges::min_element(loop.edges, {}, [](const BoundaryEdge& side) {
        return std::pair(side.edge_number == 0, side.edge_number);
    });
    std::rotate(loop.edges.begin(), smallest, loop.edges.end());
}

void orient_free_loops(std::vector<BoundaryLoop>& loops) {
    const auto faced = std::ranges::find_if(loops, has_face);
    const std::size_t reference =
        faced == loops.end() ? 0 : static_cast<std::size_t>(faced - loops.begin());
    const Eigen::Vector3d area = area_of(loops[reference]);
    for (std::size_t i = 0; i < loops.size(); ++i) {
        const bool both_islands = i > 0 && reference > 0;
        const double agree = area_of(loops[i]).dot(area);
        if (i == reference || has_face(loops[i]) || agree * (both_islands ? 1 : -1) >= 0.0) {
            continue;
        }
        std::ranges::reverse(loops[i].edges);
        for (BoundaryEdge& side : loops[i].edges) {
            side = turned(side);
        }
        begin_at_smallest(loops[i]);
    }
}

}  // namespace suture

#include "suture/detect/find_loops.h"

#include "suture/detect/classify.h"
#include "suture/detect/islands.h"
#include "suture/detect/loop_shape.h"
#include "suture/detect/seams.h"
#include "suture/detect/shell_graph.h"
#include "suture/detect/walk_loops.h"
#include "suture/occ/guard.h"

#include <TopoDS.hxx>

#include <algorithm>

namespace suture {

namespace {

/// All points of a planar loop lie within this share of its diameter of one plane.
constexpr double kPlanar = 1e-6;

/// A loop with everything known of it, to be sorted as one.
struct Found {
    RawLoop raw;
    LoopShape shape;
    BoundaryLoop loop;
};

BoundaryEdge to_edge(const ShellGraph& graph, const LoopStep& step,
                     const occ::Numbering& numbering) {
    const Coedge& use = graph.uses[step.use];
    BoundaryEdge result;
    const TopoDS_Face& face = graph.faces[use.face];
    // where the file turns the face against its shell, both are turned back: so the edge goes the
    // way of the walk and against its use in `face` all the same
    result.edge = step.along_use ? use.edge : TopoDS::Edge(use.edge.Reversed());
    result.face = step.along_use ? TopoDS::Face(face.Reversed()) : face;
    result.edge_number = numbering.of(use.edge);
    result.face_number = numbering.of(face);
    return result;
}

/// Begins the loop at its edge of the smallest number.
void rotate_to_smallest(RawLoop& loop, const ShellGraph& graph, const occ::Numbering& numbering) {
    const auto number = [&](const LoopStep& step) {
        return numbering.of(graph.uses[step.use].edge);
    };
    if (loop.closed) {
        std::rotate(loop.steps.begin(),
                    std::min_element(loop.steps.begin(), loop.steps.end(),
                                     [&](const LoopStep& a, const LoopStep& b) {
                                         return number(a) < number(b);
                                     }),
                    loop.steps.end());
    }
}

std::vector<Found> measure(const ShellGraph& graph, const occ::Numbering& numbering) {
    std::vector<Found> found;
    for (RawLoop& raw : walk_loops(graph)) {
        rotate_to_smallest(raw, graph, numbering);
        Found next{std::move(raw), {}, {}};
        next.shape = measure_loop(graph, next.raw);
        found.push_back(std::move(next));
    }
    return found;
}

std::vector<EdgePartner> partners_of(const RawLoop& loop, const std::vector<int>& index_of_use,
                                     const std::vector<EdgePartner>& partners) {
    std::vector<EdgePartner> result;
    for (const LoopStep& step : loop.steps) {
        if (index_of_use[step.use] >= 0) {
            result.push_back(partners[index_of_use[step.use]]);
        }
    }
    return result;
}

void classify_all(const ShellGraph& graph, std::vector<Found>& found) {
    std::vector<int> free_uses;
    std::vector<int> index_of_use(graph.uses.size(), -1);
    for (int i = 0; i < static_cast<int>(graph.uses.size()); ++i) {
        if (graph.uses[i].free) {
            index_of_use[i] = static_cast<int>(free_uses.size());
            free_uses.push_back(i);
        }
    }
    const std::vector<EdgePartner> partners = find_partners(graph, free_uses);
    for (Found& next : found) {
        const Verdict verdict = classify_loop(graph, next.raw, next.shape,
                                              partners_of(next.raw, index_of_use, partners));
        next.loop.kind = verdict.kind;
        next.loop.gap = verdict.gap;
        next.loop.reason = verdict.reason;
    }
}

std::vector<BoundaryLoop> find(const TopoDS_Shape& shape, const occ::Numbering& numbering) {
    const ShellGraph graph = make_shell_graph(shape);
    std::vector<Found> found = measure(graph, numbering);
    if (found.empty()) {
        return {};
    }
    classify_all(graph, found);
    for (Found& next : found) {
        for (const LoopStep& step : next.raw.steps) {
            next.loop.edges.push_back(to_edge(graph, step, numbering));
        }
        next.loop.length = next.shape.length;
        next.loop.diameter = next.shape.diameter;
        next.loop.planar = next.shape.flatness <= kPlanar * next.shape.diameter;
    }
    std::sort(found.begin(), found.end(), [](const Found& a, const Found& b) {
        return a.loop.edges.front().edge_number < b.loop.edges.front().edge_number;
    });
    std::vector<BoundaryLoop> loops;
    std::vector<LoopShape> shapes;
    std::vector<int> components;
    std::vector<int> solids;
    for (Found& next : found) {
        const int face = graph.uses[next.raw.steps.front().use].face;
        const int component = graph.component[face];
        solids.push_back(std::max(0, graph.solid[face]));
        next.loop.id = static_cast<int>(loops.size()) + 1;
        next.loop.shell_faces =
            static_cast<int>(std::count(graph.component.begin(), graph.component.end(), component));
        loops.push_back(std::move(next.loop));
        shapes.push_back(std::move(next.shape));
        components.push_back(component);
    }
    find_islands(loops, shapes, components, solids);
    return loops;
}

}  // namespace

Result<std::vector<BoundaryLoop>> find_loops(const TopoDS_Shape& shape,
                                             const occ::Numbering& numbering) {
    if (shape.IsNull()) {
        return fail(ErrorCode::Usage, "there is no shape to find holes in");
    }
    return occ::guarded("finding holes", [&] { return find(shape, numbering); });
}

}  // namespace suture

#include "suture/detect/walk_loops.h"

#include "suture/base/tolerance.h"

#include <TopExp.hxx>
#include <TopTools_DataMapOfShapeInteger.hxx>

#include <algorithm>
#include <iterator>

namespace suture {

namespace {

TopoDS_Vertex vertex_at(const EdgeUse& use, bool at_start) {
    return at_start ? TopExp::FirstVertex(use.edge, Standard_True)
                    : TopExp::LastVertex(use.edge, Standard_True);
}

/// A step before the turning is known: `turning` holds the angle that the fan of faces fills.
using FanStep = LoopStep;

/// Where the faces do not lead on (an open wire), any other free edge that begins in the vertex.
UseEnd find_by_vertex(const ShellGraph& graph, const TopoDS_Vertex& vertex, int component,
                      const std::vector<bool>& visited) {
    for (int i = 0; i < static_cast<int>(graph.uses.size()); ++i) {
        const EdgeUse& use = graph.uses[i];
        if (!use.free || visited[i] || graph.component[use.face] != component) {
            continue;
        }
        for (const bool at_start : {false, true}) {
            if (!vertex.IsNull() && vertex.IsSame(vertex_at(use, at_start))) {
                return {i, at_start};
            }
        }
    }
    return {};
}

RawLoop walk_from(const ShellGraph& graph, int start, std::vector<bool>& visited) {
    RawLoop loop;
    const int component = graph.component[graph.uses[start].face];
    // against the use, so that the material is on the right
    UseEnd leaving{start, graph.sign[graph.uses[start].face] > 0};
    while (true) {
        visited[leaving.use] = true;
        const EdgeUse& use = graph.uses[leaving.use];
        FanStep step{leaving.use, !leaving.at_start, vertex_at(use, leaving.at_start), kPi};
        const Fan fan = walk_fan(graph, leaving);
        UseEnd entering = fan.last;
        if (entering.use >= 0) {
            step.turning = fan.angle;
        } else {
            entering = find_by_vertex(graph, step.end, component, visited);
        }
        loop.steps.push_back(step);
        if (entering.use < 0) {
            const EdgeUse& first = graph.uses[start];
            loop.closed = !step.end.IsNull() &&
                          step.end.IsSame(vertex_at(first, loop.steps.front().along_use));
            return loop;
        }
        if (visited[entering.use]) {
            loop.closed = entering.use == start;
            return loop;
        }
        leaving = {entering.use, !entering.at_start};
    }
}

/// Cuts a loop wherever it comes back to a vertex: the parts bound different gaps.
void split_at_vertices(const RawLoop& loop, std::vector<RawLoop>& result) {
    std::vector<LoopStep> open;
    for (const LoopStep& step : loop.steps) {
        open.push_back(step);
        const auto same = [&step](const LoopStep& other) {
            return !step.end.IsNull() && other.end.IsSame(step.end);
        };
        const auto before = std::find_if(open.begin(), open.end() - 1, same);
        if (before != open.end() - 1) {
            result.push_back({{before + 1, open.end()}, true});
            open.erase(before + 1, open.end());
        }
    }
    if (!open.empty()) {
        result.push_back({std::move(open), loop.closed});
    }
}

/// Turns the angle that the faces fill into turning, for the parts of one walk. Where it passed a
/// vertex several times, the angle that the faces leave open is shared equally by the parts.
void measure_turning(std::vector<RawLoop>& loops) {
    TopTools_DataMapOfShapeInteger index_of;
    std::vector<double> filled;
    std::vector<int> fans;
    for (const RawLoop& loop : loops) {
        for (const LoopStep& step : loop.steps) {
            if (step.end.IsNull()) {
                continue;
            }
            if (!index_of.IsBound(step.end)) {
                index_of.Bind(step.end, static_cast<int>(filled.size()));
                filled.push_back(0.0);
                fans.push_back(0);
            }
            const int index = index_of.Find(step.end);
            filled[index] += step.turning;
            ++fans[index];
        }
    }
    for (RawLoop& loop : loops) {
        for (LoopStep& step : loop.steps) {
            const int index = step.end.IsNull() ? -1 : index_of.Find(step.end);
            const double open = index < 0 ? kPi : (2.0 * kPi - filled[index]) / fans[index];
            step.turning = open - kPi;
        }
    }
}

}  // namespace

std::vector<RawLoop> walk_loops(const ShellGraph& graph) {
    std::vector<RawLoop> loops;
    std::vector<bool> visited(graph.uses.size(), false);
    for (int i = 0; i < static_cast<int>(graph.uses.size()); ++i) {
        if (graph.uses[i].free && !visited[i]) {
            std::vector<RawLoop> parts;
            split_at_vertices(walk_from(graph, i, visited), parts);
            measure_turning(parts);
            std::move(parts.begin(), parts.end(), std::back_inserter(loops));
        }
    }
    return loops;
}

}  // namespace suture

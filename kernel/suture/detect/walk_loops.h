#pragma once

#include "suture/detect/shell_graph.h"

#include <TopoDS_Vertex.hxx>

#include <vector>

namespace suture {

/// One edge use of a loop.
struct LoopStep {
    int use = -1;
    bool along_use = false;  ///< true where the walk goes the way of the use: the file turns the
                             ///< face against the others of its shell
    TopoDS_Vertex end;     ///< the vertex that the walk reaches; null on a closed edge without any
    double turning = 0.0;  ///< to the left at `end`, seen with the material on the left
};

/// Free edges in the order in which they bound one gap of a shell, the gap on the left.
struct RawLoop {
    std::vector<LoopStep> steps;
    bool closed = true;  ///< false: a face's wire is open or its edges share no vertex
};

/// Every free edge of the graph in exactly one loop; no loop touches itself in a vertex.
[[nodiscard]] std::vector<RawLoop> walk_loops(const ShellGraph& graph);

}  // namespace suture

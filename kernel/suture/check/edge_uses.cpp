#include "suture/check/edge_uses.h"

#include <BRep_Tool.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>

namespace suture {

std::vector<std::vector<EdgeInFace>> find_edge_uses(const occ::Numbering& numbering,
                                                    const std::vector<int>& wanted) {
    const auto edge_count = static_cast<std::size_t>(numbering.edges.Extent());
    std::vector<char> is_wanted(edge_count, wanted.empty() ? 1 : 0);
    for (const int number : wanted) {
        is_wanted.at(static_cast<std::size_t>(number - 1)) = 1;
    }
    std::vector<std::vector<EdgeInFace>> uses(edge_count);
    for (int face = 1; face <= numbering.faces.Extent(); ++face) {
        const TopoDS_Shape forward = numbering.faces(face).Oriented(TopAbs_FORWARD);
        for (TopExp_Explorer it(forward, TopAbs_EDGE); it.More(); it.Next()) {
            const TopoDS_Edge& edge = TopoDS::Edge(it.Current());
            const bool bounds =
                edge.Orientation() == TopAbs_FORWARD || edge.Orientation() == TopAbs_REVERSED;
            if (!bounds) {
                continue;
            }
            const auto index = static_cast<std::size_t>(numbering.of(edge) - 1);
            if (is_wanted[index] && !BRep_Tool::Degenerated(edge)) {
                uses[index].push_back({face, edge});
            }
        }
    }
    return uses;
}

}  // namespace suture

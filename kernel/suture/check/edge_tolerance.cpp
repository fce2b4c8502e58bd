#include "suture/check/edge_tolerance.h"

#include "suture/occ/topology.h"

#include <BRep_Tool.hxx>
#include <TopoDS.hxx>

#include <algorithm>
#include <set>

namespace suture {

double EdgeTolerance::excess(double least) const {
    return now / std::max({gap, before.value_or(0.0), least});
}

std::vector<EdgeTolerance> measure_edge_tolerances(const TopoDS_Shape& shape,
                                                   const std::vector<int>& faces,
                                                   const ContinuityReport& report,
                                                   const std::map<int, double>& before) {
    const occ::Numbering numbering(shape);
    std::set<int> wanted;
    for (const int face : faces) {
        for (const TopoDS_Edge& edge : occ::edges_of(numbering.faces(face))) {
            wanted.insert(numbering.of(edge));
        }
    }
    std::vector<EdgeTolerance> result;
    for (const EdgeContinuity& edge : report.edges) {
        if (!wanted.contains(edge.edge) || edge.samples == 0) {
            continue;
        }
        EdgeTolerance entry;
        entry.edge = edge.edge;
        entry.now = BRep_Tool::Tolerance(TopoDS::Edge(numbering.edges(edge.edge)));
        entry.gap = edge.edge_gap;
        if (const auto found = before.find(edge.edge); found != before.end()) {
            entry.before = found->second;
        }
        result.push_back(entry);
    }
    return result;
}

}  // namespace suture

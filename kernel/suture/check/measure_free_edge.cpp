#include "suture/check/measure_free_edge.h"

#include "suture/check/edge_sample.h"
#include "suture/check/edge_uses.h"
#include "suture/check/measure_edge.h"
#include "suture/occ/guard.h"

#include <TopoDS.hxx>

namespace suture {
namespace {

EdgeContinuity measure(const TopoDS_Edge& edge, const TopoDS_Face& face, const EdgeInFace& use) {
    const BRepAdaptor_Curve curve(edge);
    const EdgeRange range{curve.FirstParameter(), curve.LastParameter()};
    EdgeContinuity result;
    result.length = length_of(edge, curve);
    FaceSide side(face, use.edge, range, result.length);
    for (const double t : sample_parameters(curve, range, {side, side})) {
        gp_Pnt point;
        gp_Vec along;
        curve.D1(t, point, along);
        const double gap = side.at(t, point, along).point.Distance(point);
        if (gap >= result.max_gap) {
            result.max_gap = gap;
            result.gap_at = {point.X(), point.Y(), point.Z()};
        }
        ++result.samples;
    }
    result.edge_gap = result.max_gap;
    return result;
}

}  // namespace

EdgeContinuity measure_free_edge(int edge, const occ::Numbering& numbering) {
    const auto uses = find_edge_uses(numbering, {edge});
    const EdgeInFace& use = uses[static_cast<std::size_t>(edge - 1)].front();
    auto measured = occ::guarded("measuring the edge", [&] {
        return measure(TopoDS::Edge(numbering.edges(edge)), TopoDS::Face(numbering.faces(use.face)),
                       use);
    });
    EdgeContinuity result;
    if (measured) {
        result = std::move(*measured);
    } else {
        result.note = measured.error().message;
    }
    result.edge = edge;
    result.faces = {use.face, 0};
    return result;
}

}  // namespace suture

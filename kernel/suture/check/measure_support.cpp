#include "suture/check/measure_support.h"

#include "suture/base/tolerance.h"
#include "suture/occ/handle.h"

#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Geom2d_Curve.hxx>
#include <GeomProjLib.hxx>
#include <Geom_Curve.hxx>
#include <Geom_Surface.hxx>
#include <TopAbs.hxx>

namespace suture {
namespace {

/// The support's surface as a face that uses a copy of the edge.
struct Stand {
    TopoDS_Face face;
    EdgeInFace use;
};

Stand stand_on(const TopoDS_Edge& edge, const TopoDS_Face& support) {
    double first = 0.0;
    double last = 0.0;
    const occ::Handle<Geom_Curve> curve = BRep_Tool::Curve(edge, first, last);
    const occ::Handle<Geom_Surface> surface = BRep_Tool::Surface(support);
    const occ::Handle<Geom2d_Curve> on_surface = GeomProjLib::Curve2d(curve, first, last, surface);
    const double tolerance = BRep_Tool::Tolerance(edge);
    const BRep_Builder builder;
    Stand stand;
    builder.MakeFace(stand.face, surface, tolerance);
    builder.MakeEdge(stand.use.edge, curve, tolerance);
    if (!on_surface.IsNull()) {  // else the nearest points are sought without
        builder.UpdateEdge(stand.use.edge, on_surface, stand.face, tolerance);
    }
    builder.Range(stand.use.edge, first, last);
    return stand;
}

}  // namespace

EdgeContinuity measure_support(const TopoDS_Edge& edge, const TopoDS_Face& face,
                               const EdgeInFace& use, const TopoDS_Face& support) {
    Stand stand = stand_on(edge, support);
    EdgeContinuity best;
    for (const TopAbs_Orientation facing : {TopAbs_FORWARD, TopAbs_REVERSED}) {
        stand.face.Orientation(facing);
        // Two faces with one side use their edge in opposite directions.
        const TopAbs_Orientation along =
            TopAbs::Compose(TopAbs::Compose(face.Orientation(), use.edge.Orientation()), facing);
        stand.use.edge.Orientation(TopAbs::Reverse(along));
        EdgeContinuity figures = measure_edge(edge, {face, stand.face}, {use, stand.use});
        if (best.samples == 0 || figures.max_angle < best.max_angle) {
            best = std::move(figures);
        }
    }
    return best;
}

}  // namespace suture

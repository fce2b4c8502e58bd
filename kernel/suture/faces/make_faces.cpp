#include "suture/faces/make_faces.h"

#include "suture/faces/pcurve.h"
#include "suture/occ/convert.h"
#include "suture/occ/guard.h"

#include <BRepCheck_Analyzer.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Geom2d_Curve.hxx>
#include <Geom_Curve.hxx>
#include <Geom_Plane.hxx>
#include <Precision.hxx>
#include <TopExp.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Wire.hxx>

#include <algorithm>
#include <cmath>

namespace suture {
namespace {

using occ::Handle;

/// Samples per edge for the distance between its curve and the new surface; BRepCheck uses 23.
constexpr int kSamples = 92;

/// A tolerance covers what was sampled and a little more, for what lies between the samples.
constexpr double kMargin = 1.01;

/// The largest distance between an edge's curve and its trace on the surface, at equal parameters.
double distance_along(const Geom_Curve& curve, double first, double last,
                      const std::function<gp_Pnt(double)>& on_surface) {
    double largest = 0.0;
    for (int k = 0; k <= kSamples; ++k) {
        const double t = first + (last - first) * k / kSamples;
        largest = std::max(largest, curve.Value(t).Distance(on_surface(t)));
    }
    return largest;
}

/// Gives the edge its curve on the new surface; planes need none. Returns the largest distance.
double put_on_surface(const TopoDS_Edge& edge, const Handle<Geom_Surface>& surface,
                      const Ribbon& ribbon, const TrimCurve& trim, double accuracy) {
    double first = 0.0;
    double last = 0.0;
    const Handle<Geom_Curve> curve = BRep_Tool::Curve(edge, first, last);
    const BRep_Builder builder;
    double distance = 0.0;
    if (const auto plane = occ::cast<Geom_Plane>(surface)) {
        const gp_Pln pln = plane->Pln();
        for (int k = 0; k <= kSamples; ++k) {
            const double t = first + (last - first) * k / kSamples;
            distance = std::max(distance, pln.Distance(curve->Value(t)));
        }
    } else {
        const auto at = [&](double t) {
            return trim((t - ribbon.first) / (ribbon.last - ribbon.first));
        };
        const Handle<Geom2d_Curve> pcurve = fit_pcurve(at, first, last, *surface, accuracy);
        distance = distance_along(*curve, first, last, [&](double t) {
            const gp_Pnt2d uv = pcurve->Value(t);
            return surface->Value(uv.X(), uv.Y());
        });
        builder.UpdateEdge(edge, pcurve, surface, TopLoc_Location(), 0.0);
    }
    if (distance > BRep_Tool::Tolerance(edge)) {
        const double needed = distance * kMargin;
        builder.UpdateEdge(edge, needed);
        for (const TopoDS_Vertex& vertex : {TopExp::FirstVertex(edge), TopExp::LastVertex(edge)}) {
            builder.UpdateVertex(vertex, needed);
        }
    }
    return distance;
}

TopoDS_Wire wire_of(std::vector<TopoDS_Edge> edges, bool reversed) {
    if (reversed) {
        std::reverse(edges.begin(), edges.end());
    }
    const BRep_Builder builder;
    TopoDS_Wire wire;
    builder.MakeWire(wire);
    for (TopoDS_Edge& edge : edges) {
        builder.Add(wire, reversed ? TopoDS::Edge(edge.Reversed()) : edge);
    }
    wire.Closed(Standard_True);
    return wire;
}

Result<NewFaces> make(const std::vector<BoundaryLoop>& loops, const Hole& hole,
                      const FillResult& result) {
    NewFaces made;
    for (const Patch& patch : result.patches) {
        const auto surface = occ::to_occ(patch.surface);
        if (!surface) {
            return tl::unexpected(surface.error());
        }
        const BRep_Builder builder;
        TopoDS_Face face;
        builder.MakeFace(face, *surface, Precision::Confusion());
        const double accuracy = kPcurveAccuracy * hole.diameter;
        for (std::size_t l = 0; l < loops.size(); ++l) {
            std::vector<TopoDS_Edge> edges;
            for (std::size_t i = 0; i < loops[l].edges.size(); ++i) {
                const TopoDS_Edge& edge = loops[l].edges[i].edge;
                made.max_gap =
                    std::max(made.max_gap, put_on_surface(edge, *surface, hole.loops[l].ribbons[i],
                                                          patch.trims[l][i], accuracy));
                edges.push_back(edge);
            }
            builder.Add(face, wire_of(std::move(edges), patch.reversed));
        }
        if (patch.reversed) {
            face.Reverse();
        }
        made.faces.push_back(face);
    }
    return made;
}

}  // namespace

Result<NewFaces> make_faces(const std::vector<BoundaryLoop>& loops, const Hole& hole,
                            const FillResult& result) {
    return occ::guarded("making the new face", [&] { return make(loops, hole, result); });
}

}  // namespace suture

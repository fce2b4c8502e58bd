#include "suture/faces/make_faces.h"

#include "suture/faces/pcurve.h"
#include "suture/faces/seam.h"
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

/// Samples per edge for the distance between its curve and the new surface.
constexpr int kSamples = 400;

/// Golden sections of the intervals about a peak among the samples: below 1e-6 of its width.
constexpr int kSections = 28;

/// Peaks this much lower than the highest sample cannot hide the largest distance.
constexpr double kWorthALook = 0.5;

/// A tolerance covers the largest distance found and a little more.
constexpr double kMargin = 1.01;

/// The largest value in an interval that has one peak.
double peak(const std::function<double(double)>& f, double low, double high) {
    const double golden = 0.5 * (std::sqrt(5.0) - 1.0);
    double a = high - golden * (high - low);
    double b = low + golden * (high - low);
    double at_a = f(a);
    double at_b = f(b);
    for (int k = 0; k < kSections; ++k) {
        if (at_a > at_b) {
            high = b;
            b = a;
            at_b = at_a;
            a = high - golden * (high - low);
            at_a = f(a);
        } else {
            low = a;
            a = b;
            at_a = at_b;
            b = low + golden * (high - low);
            at_b = f(b);
        }
    }
    return std::max(at_a, at_b);
}

/// The largest distance along an edge: BRepCheck samples elsewhere than we do, so that the peaks
/// count.
double largest_along(double first, double last, const std::function<double(double)>& distance) {
    const auto parameter = [&](int k) { return first + (last - first) * k / kSamples; };
    std::vector<double> samples;
    for (int k = 0; k <= kSamples; ++k) {
        samples.push_back(distance(parameter(k)));
    }
    const double highest = *std::max_element(samples.begin(), samples.end());
    double largest = highest;
    for (int k = 0; k <= kSamples; ++k) {
        const int before = std::max(k - 1, 0);
        const int after = std::min(k + 1, kSamples);
        const auto value = [&](int i) { return samples[static_cast<std::size_t>(i)]; };
        if (value(k) >= std::max({value(before), value(after), kWorthALook * highest})) {
            largest = std::max(largest, peak(distance, parameter(before), parameter(after)));
        }
    }
    return largest;
}

/// Gives the edge its curve on the new surface; planes need none.
void put_on_surface(const TopoDS_Edge& edge, const Handle<Geom_Surface>& surface,
                    const Ribbon& ribbon, const TrimCurve& trim, double accuracy, NewFaces& made) {
    double first = 0.0;
    double last = 0.0;
    const Handle<Geom_Curve> curve = BRep_Tool::Curve(edge, first, last);
    const BRep_Builder builder;
    double distance = 0.0;
    if (const auto plane = occ::cast<Geom_Plane>(surface)) {
        const gp_Pln pln = plane->Pln();
        distance =
            largest_along(first, last, [&](double t) { return pln.Distance(curve->Value(t)); });
    } else {
        const auto at = [&](double t) {
            return trim((t - ribbon.first) / (ribbon.last - ribbon.first));
        };
        const Handle<Geom2d_Curve> pcurve = fit_pcurve(at, first, last, *surface, accuracy);
        distance = largest_along(first, last, [&](double t) {
            const gp_Pnt2d uv = pcurve->Value(t);
            return curve->Value(t).Distance(surface->Value(uv.X(), uv.Y()));
        });
        builder.UpdateEdge(edge, pcurve, surface, TopLoc_Location(), 0.0);
    }
    if (distance > BRep_Tool::Tolerance(edge)) {
        const double needed = distance * kMargin;
        builder.UpdateEdge(edge, needed);
        for (const TopoDS_Vertex& vertex : {TopExp::FirstVertex(edge), TopExp::LastVertex(edge)}) {
            builder.UpdateVertex(vertex, needed);
        }
        ++made.grown_edges;
        made.grown_tolerance = std::max(made.grown_tolerance, needed);
    }
    made.max_gap = std::max(made.max_gap, distance);
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

TopoDS_Vertex start_of(const TopoDS_Edge& edge) {
    return TopExp::FirstVertex(edge, /*CumOri=*/Standard_True);
}

/// The edges of the loops on one new surface.
class Outline {
  public:
    Outline(const std::vector<BoundaryLoop>& loops, const Patch& patch,
            Handle<Geom_Surface> surface, double accuracy)
        : loops_(loops), patch_(patch), surface_(std::move(surface)), accuracy_(accuracy) {}

    [[nodiscard]] std::vector<TopoDS_Wire> wires() const {
        std::vector<TopoDS_Wire> wires;
        const auto& seam = patch_.seam;
        for (int l = 0; l < static_cast<int>(loops_.size()); ++l) {
            if (!seam || (l != seam->loop && l != seam->other_loop)) {
                wires.push_back(wire_of(around(l, 0), patch_.reversed));
            }
        }
        if (seam) {
            wires.insert(wires.begin(), wire_of(along_seam(*seam), patch_.reversed));
        }
        return wires;
    }

  private:
    const std::vector<BoundaryLoop>& loops_;
    const Patch& patch_;
    Handle<Geom_Surface> surface_;
    double accuracy_;

    [[nodiscard]] const TopoDS_Edge& edge(int loop, int side) const {
        return loops_[static_cast<std::size_t>(loop)].edges[static_cast<std::size_t>(side)].edge;
    }

    /// A loop's edges from a corner on, with an edge without length where it passes a pole.
    [[nodiscard]] std::vector<TopoDS_Edge> around(int loop, int corner) const {
        const auto& trims = patch_.trims[static_cast<std::size_t>(loop)];
        const int n = static_cast<int>(trims.size());
        std::vector<TopoDS_Edge> edges;
        for (int k = 0; k < n; ++k) {
            const int i = (corner + k) % n;
            const int next = (i + 1) % n;
            edges.push_back(edge(loop, i));
            if (in_pole(loop, next)) {
                edges.push_back(make_degenerated(trims[static_cast<std::size_t>(i)](1.0),
                                                 trims[static_cast<std::size_t>(next)](0.0),
                                                 surface_, start_of(edge(loop, next))));
            }
        }
        return edges;
    }

    [[nodiscard]] bool in_pole(int loop, int corner) const {
        if (patch_.pole_corners.empty()) {
            return false;
        }
        const auto& corners = patch_.pole_corners[static_cast<std::size_t>(loop)];
        return std::find(corners.begin(), corners.end(), corner) != corners.end();
    }

    [[nodiscard]] std::vector<TopoDS_Edge> along_seam(const Seam& seam) const {
        std::vector<TopoDS_Edge> edges = around(seam.loop, seam.corner);
        const TopoDS_Vertex start = start_of(edge(seam.loop, seam.corner));
        TopoDS_Vertex end;
        std::vector<TopoDS_Edge> beyond;
        if (seam.other_loop >= 0) {
            end = start_of(edge(seam.other_loop, seam.other_corner));
            beyond = around(seam.other_loop, seam.other_corner);
        } else {
            BRep_Builder().MakeVertex(end, surface_->Value(seam.to.x(), seam.to.y()),
                                      Precision::Confusion());
            beyond = {make_degenerated(seam.to + seam.period, seam.to, surface_, end)};
        }
        const TopoDS_Edge cut = make_seam(seam, surface_, start, end, patch_.reversed, accuracy_);
        edges.push_back(cut);
        edges.insert(edges.end(), beyond.begin(), beyond.end());
        edges.push_back(TopoDS::Edge(cut.Reversed()));
        return edges;
    }
};

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
            for (std::size_t i = 0; i < loops[l].edges.size(); ++i) {
                put_on_surface(loops[l].edges[i].edge, *surface, hole.loops[l].ribbons[i],
                               patch.trims[l][i], accuracy, made);
            }
        }
        for (const TopoDS_Wire& wire : Outline(loops, patch, *surface, accuracy).wires()) {
            builder.Add(face, wire);
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

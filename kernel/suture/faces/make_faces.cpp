#include "suture/faces/make_faces.h"

#include "suture/faces/inner_edges.h"
#include "suture/faces/pcurve.h"
#include "suture/faces/put_on_surface.h"
#include "suture/faces/seam.h"
#include "suture/occ/convert.h"
#include "suture/occ/guard.h"

#include <BRep_Builder.hxx>
#include <Precision.hxx>
#include <TopExp.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Wire.hxx>

#include <algorithm>

namespace suture {
namespace {

using occ::Handle;

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

/// The faces of one fill.
class FaceMaker {
  public:
    FaceMaker(const std::vector<BoundaryLoop>& loops, const Hole& hole, const FillResult& result)
        : loops_(loops),
          hole_(hole),
          accuracy_(kPcurveAccuracy * hole.diameter),
          inner_(loops, result, accuracy_) {}

    [[nodiscard]] Result<void> add(const Patch& patch) {
        const auto surface = occ::to_occ(patch.surface);
        if (!surface) {
            return tl::unexpected(surface.error());
        }
        const BRep_Builder builder;
        TopoDS_Face face;
        builder.MakeFace(face, *surface, Precision::Confusion());
        for (const TopoDS_Wire& wire :
             patch.wires.empty() ? trimmed(patch, *surface) : outlined(patch, *surface)) {
            builder.Add(face, wire);
        }
        if (patch.reversed) {
            face.Reverse();
        }
        made_.faces.push_back(face);
        return {};
    }

    [[nodiscard]] NewFaces take() { return std::move(made_); }

  private:
    const std::vector<BoundaryLoop>& loops_;
    const Hole& hole_;
    double accuracy_;
    InnerEdges inner_;
    NewFaces made_;

    /// The wires of a patch that fills the hole alone.
    [[nodiscard]] std::vector<TopoDS_Wire> trimmed(const Patch& patch,
                                                   const Handle<Geom_Surface>& surface) {
        // Seams and poles stand where the layout has its corners.
        const bool corners_free =
            !patch.seam && std::ranges::all_of(patch.pole_corners,
                                               [](const auto& corners) { return corners.empty(); });
        const Ends ends = corners_free ? Ends::Feet : Ends::Laid;
        for (std::size_t l = 0; l < loops_.size(); ++l) {
            for (std::size_t i = 0; i < loops_[l].edges.size(); ++i) {
                put_side(static_cast<int>(l), static_cast<int>(i), patch.trims[l][i], surface,
                         ends);
            }
        }
        return Outline(loops_, patch, surface, accuracy_).wires();
    }

    /// The wires of a patch among others.
    [[nodiscard]] std::vector<TopoDS_Wire> outlined(const Patch& patch,
                                                    const Handle<Geom_Surface>& surface) {
        std::vector<TopoDS_Wire> wires;
        for (const std::vector<EdgeUse>& uses : patch.wires) {
            std::vector<TopoDS_Edge> edges;
            for (std::size_t k = 0; k < uses.size(); ++k) {
                const EdgeUse& use = uses[k];
                edges.push_back(put(use, patch, surface));
                if (use.pole_after) {
                    const EdgeUse& next = uses[(k + 1) % uses.size()];
                    edges.push_back(make_degenerated(
                        use.at(use.backwards ? 0.0 : 1.0), next.at(next.backwards ? 1.0 : 0.0),
                        surface, TopExp::LastVertex(edges.back(), /*CumOri=*/Standard_True)));
                }
            }
            wires.push_back(wire_of(std::move(edges), patch.reversed));
        }
        return wires;
    }

    [[nodiscard]] TopoDS_Edge put(const EdgeUse& use, const Patch& patch,
                                  const Handle<Geom_Surface>& surface) {
        if (use.loop >= 0) {
            put_side(use.loop, use.index, use.at, surface, Ends::Laid);
            return loops_[static_cast<std::size_t>(use.loop)]
                .edges[static_cast<std::size_t>(use.index)]
                .edge;
        }
        const TopoDS_Edge& edge = inner_.edge(use, surface);
        const EdgeUse* other = other_use(use, patch);
        if (other == nullptr) {
            note(put_on_surface(edge, surface, use.at, Ends::Laid, accuracy_));
        } else if (!use.backwards) {
            // Turning the wires over turns the uses over.
            note(patch.reversed
                     ? put_on_surface_twice(edge, surface, other->at, use.at, accuracy_)
                     : put_on_surface_twice(edge, surface, use.at, other->at, accuracy_));
        }
        return use.backwards ? TopoDS::Edge(edge.Reversed()) : edge;
    }

    /// The other use of a seam.
    static const EdgeUse* other_use(const EdgeUse& use, const Patch& patch) {
        for (const std::vector<EdgeUse>& uses : patch.wires) {
            for (const EdgeUse& other : uses) {
                if (&other != &use && other.loop < 0 && other.index == use.index) {
                    return &other;
                }
            }
        }
        return nullptr;
    }

    void put_side(int loop, int side, const TrimCurve& trim, const Handle<Geom_Surface>& surface,
                  Ends ends) {
        const auto l = static_cast<std::size_t>(loop);
        const auto i = static_cast<std::size_t>(side);
        const Ribbon& ribbon = hole_.loops[l].ribbons[i];
        const auto at = [&](double t) {
            return trim((t - ribbon.first) / (ribbon.last - ribbon.first));
        };
        note(put_on_surface(loops_[l].edges[i].edge, surface, at, ends, accuracy_));
    }

    void note(const Placed& placed) {
        made_.max_gap = std::max(made_.max_gap, placed.gap);
        if (placed.tolerance > 0.0) {
            ++made_.grown_edges;
            made_.grown_tolerance = std::max(made_.grown_tolerance, placed.tolerance);
        }
    }
};

}  // namespace

Result<NewFaces> make_faces(const std::vector<BoundaryLoop>& loops, const Hole& hole,
                            const FillResult& result) {
    return occ::guarded("making the new face", [&]() -> Result<NewFaces> {
        FaceMaker maker(loops, hole, result);
        for (const Patch& patch : result.patches) {
            if (const auto added = maker.add(patch); !added) {
                return tl::unexpected(added.error());
            }
        }
        return maker.take();
    });
}

}  // namespace suture

#include "suture/faces/make_faces.h"

#include "suture/faces/inner_edges.h"
#include "suture/faces/own_form.h"
#include "suture/faces/pcurve.h"
#include "suture/faces/pole_edge.h"
#include "suture/faces/put_on_surface.h"
#include "suture/occ/convert.h"
#include "suture/occ/guard.h"

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Precision.hxx>
#include <TopExp.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Wire.hxx>

#include <algorithm>
#include <functional>
#include <utility>

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

/// One use of an edge by a new face.
struct Laid {
    const EdgeUse* use = nullptr;
    TopoDS_Edge edge;  ///< from its start to its end
    std::function<Eigen::Vector2d(double t)> at;
    Placement placement;
};

/// A new face before it is made.
struct Sheet {
    const Patch* patch = nullptr;
    Handle<Geom_Surface> surface;
    Ends ends = Ends::Laid;
    std::vector<std::vector<Laid>> wires;

    /// The other use of a seam.
    [[nodiscard]] const Laid* other(const Laid& laid) const {
        for (const std::vector<Laid>& wire : wires) {
            for (const Laid& one : wire) {
                if (&one != &laid && one.use->loop < 0 && one.use->index == laid.use->index) {
                    return &one;
                }
            }
        }
        return nullptr;
    }
};

/// Seams, poles and other patches rely on the layout's corners; a hole's sides alone need not.
Ends ends_of(const Patch& patch) {
    for (const std::vector<EdgeUse>& wire : patch.wires) {
        for (const EdgeUse& use : wire) {
            if (use.loop < 0 || use.pole_after) {
                return Ends::Laid;
            }
        }
    }
    return Ends::Feet;
}

}  // namespace

class PlacedFaces::Maker {
  public:
    Maker(const std::vector<BoundaryLoop>& loops, const Hole& hole, const FillResult& result)
        : loops_(loops),
          hole_(hole),
          accuracy_(kPcurveAccuracy * hole.diameter),
          inner_(loops, result, accuracy_) {}

    [[nodiscard]] Result<void> lay_out(const Patch& patch) {
        if (const auto own = own_form_of(patch, loops_, hole_)) {
            lay_out_on(*own, patch);
            return {};
        }
        const auto surface = occ::to_occ(patch.surface);
        if (!surface) {
            return tl::unexpected(surface.error());
        }
        Sheet& sheet = sheets_.emplace_back(Sheet{&patch, *surface, ends_of(patch), {}});
        for (const std::vector<EdgeUse>& uses : patch.wires) {
            std::vector<Laid>& wire = sheet.wires.emplace_back();
            for (const EdgeUse& use : uses) {
                wire.push_back(use.loop >= 0 ? side(use) : inner(use, *surface));
            }
        }
        return {};
    }

    /// Finds all curves on the new surfaces, on all cores: most of the work, and it changes
    /// nothing.
    [[nodiscard]] Result<void> place(const std::vector<Placement>& known) {
        const std::vector<std::pair<const Sheet*, Laid*>> all = uses();
        std::vector<Result<void>> placed(all.size());
        // Isolated: a thread that waits here must not begin another hole.
        tbb::this_task_arena::isolate([&] {
            tbb::parallel_for(std::size_t{0}, all.size(), [&](std::size_t i) {
                const Sheet* sheet = all[i].first;
                Laid* laid = all[i].second;
                if (i < known.size() && known[i].holds_for(laid->edge)) {
                    laid->placement = known[i];
                    return;
                }
                placed[i] = occ::guarded("a curve on a new face", [&] {
                    laid->placement = place_on_surface(laid->edge, sheet->surface, laid->at,
                                                       sheet->ends, accuracy_);
                });
            });
        });
        const auto failed = std::ranges::find_if(placed, [](const auto& one) { return !one; });
        return failed == placed.end() ? Result<void>() : *failed;
    }

    [[nodiscard]] NewFaces make() {
        for (const Sheet& sheet : sheets_) {
            made_.faces.push_back(face_of(sheet));
        }
        for (const auto& [sheet, laid] : uses()) {
            made_.placements.push_back(laid->placement);
        }
        return std::move(made_);
    }

  private:
    /// Of all edges by the new faces, in the order of the patches' wires.
    [[nodiscard]] std::vector<std::pair<const Sheet*, Laid*>> uses() {
        std::vector<std::pair<const Sheet*, Laid*>> all;
        for (Sheet& sheet : sheets_) {
            for (std::vector<Laid>& wire : sheet.wires) {
                for (Laid& laid : wire) {
                    all.emplace_back(&sheet, &laid);
                }
            }
        }
        return all;
    }

    /// On a neighbour's own surface, which has parameters of its own.
    void lay_out_on(const OwnForm& own, const Patch& patch) {
        Sheet& sheet = sheets_.emplace_back(Sheet{&patch, own.surface, Ends::Feet, {}});
        for (const std::vector<EdgeUse>& uses : patch.wires) {
            std::vector<Laid>& wire = sheet.wires.emplace_back();
            for (const EdgeUse& use : uses) {
                Laid& laid = wire.emplace_back(side(use));
                const auto l = static_cast<std::size_t>(use.loop);
                const auto i = static_cast<std::size_t>(use.index);
                const Ribbon& ribbon = hole_.loops[l].ribbons[i];
                laid.at = [first = ribbon.first, last = ribbon.last,
                           uvs = own.trace[l][i]](double t) -> Eigen::Vector2d {
                    const double s = std::clamp((t - first) / (last - first), 0.0, 1.0);
                    const double place = s * (kTraced - 1);
                    const auto k = std::min(static_cast<std::size_t>(place), uvs.size() - 2);
                    const double share = place - static_cast<double>(k);
                    return (1.0 - share) * uvs[k] + share * uvs[k + 1];
                };
            }
        }
    }

    const std::vector<BoundaryLoop>& loops_;
    const Hole& hole_;
    double accuracy_;
    InnerEdges inner_;
    std::vector<Sheet> sheets_;
    NewFaces made_;

    [[nodiscard]] Laid side(const EdgeUse& use) const {
        const auto l = static_cast<std::size_t>(use.loop);
        const auto i = static_cast<std::size_t>(use.index);
        const Ribbon& ribbon = hole_.loops[l].ribbons[i];
        return {&use,
                loops_[l].edges[i].edge,
                [&use, first = ribbon.first, last = ribbon.last](double t) {
                    return use.at((t - first) / (last - first));
                },
                {}};
    }

    [[nodiscard]] Laid inner(const EdgeUse& use, const Handle<Geom_Surface>& surface) {
        const TopoDS_Edge& edge = inner_.edge(use, surface);
        double first = 0.0;
        double last = 0.0;
        BRep_Tool::Range(edge, first, last);
        return {&use,
                edge,
                [&use, first, last](double t) { return use.at((t - first) / (last - first)); },
                {}};
    }

    [[nodiscard]] TopoDS_Face face_of(const Sheet& sheet) {
        const Patch& patch = *sheet.patch;
        const BRep_Builder builder;
        TopoDS_Face face;
        builder.MakeFace(face, sheet.surface, Precision::Confusion());
        for (const std::vector<Laid>& laid : sheet.wires) {
            std::vector<TopoDS_Edge> edges;
            for (std::size_t k = 0; k < laid.size(); ++k) {
                put(laid[k], sheet);
                const EdgeUse& use = *laid[k].use;
                edges.push_back(use.backwards ? TopoDS::Edge(laid[k].edge.Reversed())
                                              : laid[k].edge);
                if (use.pole_after) {
                    const EdgeUse& next = *laid[(k + 1) % laid.size()].use;
                    edges.push_back(make_pole_edge(
                        use.at(use.backwards ? 0.0 : 1.0), next.at(next.backwards ? 1.0 : 0.0),
                        sheet.surface, TopExp::LastVertex(edges.back(), /*CumOri=*/Standard_True)));
                }
            }
            builder.Add(face, wire_of(std::move(edges), patch.reversed));
        }
        if (patch.reversed) {
            face.Reverse();
        }
        return face;
    }

    void put(const Laid& laid, const Sheet& sheet) {
        const Laid* other = laid.use->loop < 0 ? sheet.other(laid) : nullptr;
        if (other == nullptr) {
            note(put_on_surface(laid.edge, sheet.surface, laid.placement));
        } else if (!laid.use->backwards) {
            // Turning the wires over turns the uses over.
            const auto& [forward, backward] =
                sheet.patch->reversed ? std::pair(other, &laid) : std::pair(&laid, other);
            note(put_on_surface_twice(laid.edge, sheet.surface, forward->placement,
                                      backward->placement));
        }
    }

    void note(const Placed& placed) {
        made_.max_gap = std::max(made_.max_gap, placed.gap);
        if (placed.tolerance > 0.0) {
            ++made_.grown_edges;
            made_.grown_tolerance = std::max(made_.grown_tolerance, placed.tolerance);
        }
    }
};

PlacedFaces::PlacedFaces(std::unique_ptr<Maker> maker) : maker_(std::move(maker)) {}
PlacedFaces::PlacedFaces(PlacedFaces&& other) noexcept = default;
PlacedFaces& PlacedFaces::operator=(PlacedFaces&& other) noexcept = default;
PlacedFaces::~PlacedFaces() = default;

Result<NewFaces> PlacedFaces::make() {
    return occ::guarded("making the new face", [&] { return maker_->make(); });
}

Result<PlacedFaces> place_faces(const std::vector<BoundaryLoop>& loops, const Hole& hole,
                                const FillResult& result, const std::vector<Placement>& known) {
    return occ::guarded("making the new face", [&]() -> Result<PlacedFaces> {
        auto maker = std::make_unique<PlacedFaces::Maker>(loops, hole, result);
        for (const Patch& patch : result.patches) {
            if (const auto laid = maker->lay_out(patch); !laid) {
                return tl::unexpected(laid.error());
            }
        }
        if (const auto placed = maker->place(known); !placed) {
            return tl::unexpected(placed.error());
        }
        return PlacedFaces(std::move(maker));
    });
}

Result<NewFaces> make_faces(const std::vector<BoundaryLoop>& loops, const Hole& hole,
                            const FillResult& result) {
    auto placed = place_faces(loops, hole, result);
    if (!placed) {
        return tl::unexpected(placed.error());
    }
    return placed->make();
}

}  // namespace suture

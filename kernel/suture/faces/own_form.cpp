#include "suture/faces/own_form.h"

#include "suture/occ/convert.h"
#include "suture/occ/guard.h"
#include "suture/occ/model_surface.h"

#include <BRep_Tool.hxx>
#include <GeomLProp_SLProps.hxx>
#include <Geom_OffsetSurface.hxx>
#include <Geom_RectangularTrimmedSurface.hxx>
#include <Geom_SurfaceOfLinearExtrusion.hxx>
#include <Geom_SurfaceOfRevolution.hxx>
#include <ShapeAnalysis_Surface.hxx>

#include <algorithm>
#include <cmath>
#include <utility>
#include <variant>

namespace suture {
namespace {

using occ::from_occ;
using occ::Handle;
using occ::to_point;

/// As shares of the hole's diameter: how far its border may lie off, and how near a foot is sought.
constexpr double kOff = 1e-3;
constexpr double kNear = 1e-6;

/// Half way between two points in (u, v) is half way in space, but for this share of their
/// distance: else a seam lies between them.
constexpr double kAstray = 0.5;

/// A copy as a B-spline lies so near to what it is a copy of, as a share of the diameter, at so
/// many by so many points.
constexpr double kCopied = 2e-7;
constexpr int kCompared = 6;

/// Walks along curves on a surface.
class Walk {
  public:
    Walk(const Handle<Geom_Surface>& surface, double diameter)
        : surface_(surface),
          feet_(surface),
          off_(kOff * diameter),
          near_(kNear * diameter),
          period_(surface->IsUPeriodic() ? surface->UPeriod() : 0.0,
                  surface->IsVPeriodic() ? surface->VPeriod() : 0.0) {}

    [[nodiscard]] const Eigen::Vector2d& period() const { return period_; }

    void begin() { started_ = false; }

    /// The next point's (u, v).
    [[nodiscard]] std::optional<Eigen::Vector2d> to(const Eigen::Vector3d& next) {
        const gp_Pnt point = to_point(next);
        gp_Pnt2d foot = started_ ? feet_.NextValueOfUV(to_point(uv_), point, near_)
                                 : feet_.ValueOfUV(point, near_);
        if (started_ && !(distance(from_occ(foot), point) <= off_)) {
            foot = feet_.ValueOfUV(point, near_);
        }
        Eigen::Vector2d uv = from_occ(foot);
        if (!(distance(uv, point) <= off_)) {
            return std::nullopt;
        }
        if (started_) {
            uv = in_period(uv, uv_);
            const gp_Pnt middle(0.5 * (point_.XYZ() + point.XYZ()));
            if (distance(0.5 * (uv + uv_), middle) > kAstray * point_.Distance(point) + off_) {
                return std::nullopt;
            }
        }
        started_ = true;
        uv_ = uv;
        point_ = point;
        return uv;
    }

    /// The place of a point of the domain that is nearest to another one.
    [[nodiscard]] Eigen::Vector2d in_period(Eigen::Vector2d uv, const Eigen::Vector2d& near) const {
        for (const int c : {0, 1}) {
            if (period_[c] > 0.0) {
                uv[c] = near[c] + std::remainder(uv[c] - near[c], period_[c]);
            }
        }
        return uv;
    }

  private:
    const Handle<Geom_Surface>& surface_;
    ShapeAnalysis_Surface feet_;
    double off_, near_;
    Eigen::Vector2d period_;
    bool started_ = false;
    Eigen::Vector2d uv_;
    gp_Pnt point_;

    [[nodiscard]] double distance(const Eigen::Vector2d& uv, const gp_Pnt& point) const {
        return surface_->Value(uv.x(), uv.y()).Distance(point);
    }
};

using LoopTrace = std::vector<std::vector<Eigen::Vector2d>>;

std::optional<LoopTrace> trace_of(Walk& walk, const RibbonLoop& loop) {
    LoopTrace trace;
    walk.begin();
    for (const Ribbon& ribbon : loop.ribbons) {
        auto& side = trace.emplace_back();
        for (int k = 0; k < kTraced; ++k) {
            const auto uv = walk.to(ribbon.at(static_cast<double>(k) / (kTraced - 1)).point);
            if (!uv) {
                return std::nullopt;
            }
            side.push_back(*uv);
        }
    }
    // Less than half a period from its start: it does not go around.
    const Eigen::Vector2d start = trace.front().front();
    const Eigen::Vector2d end = trace.back().back();
    return (walk.in_period(start, end) - start).norm() < 1e-6 * walk.period().norm() + 1e-300
               ? std::optional(trace)
               : std::nullopt;
}

Eigen::Vector2d middle_of(const LoopTrace& trace) {
    Eigen::Vector2d sum = Eigen::Vector2d::Zero();
    for (const auto& side : trace) {
        for (const Eigen::Vector2d& uv : side) {
            sum += uv / static_cast<double>(trace.size() * kTraced);
        }
    }
    return sum;
}

/// The kind of a surface that Surface has as a B-spline only.
std::optional<std::string> kind_of(Handle<Geom_Surface> surface) {
    while (const auto trimmed = occ::cast<Geom_RectangularTrimmedSurface>(surface)) {
        surface = trimmed->BasisSurface();
    }
    if (occ::cast<Geom_SurfaceOfLinearExtrusion>(surface)) {
        return "surface of extrusion";
    }
    if (occ::cast<Geom_SurfaceOfRevolution>(surface)) {
        return "surface of revolution";
    }
    return occ::cast<Geom_OffsetSurface>(surface) ? std::optional<std::string>("offset surface")
                                                  : std::nullopt;
}

/// Whether a B-spline lies on a surface, the same side out.
bool is_copy(const Handle<Geom_Surface>& spline, const Handle<Geom_Surface>& surface,
             double diameter) {
    double u0 = 0.0;
    double u1 = 0.0;
    double v0 = 0.0;
    double v1 = 0.0;
    spline->Bounds(u0, u1, v0, v1);
    ShapeAnalysis_Surface feet(surface);
    constexpr double kRounding = 1e-12;
    for (int i = 0; i <= kCompared; ++i) {
        for (int j = 0; j <= kCompared; ++j) {
            GeomLProp_SLProps here(spline, u0 + (u1 - u0) * i / kCompared,
                                   v0 + (v1 - v0) * j / kCompared, 1, kRounding);
            const gp_Pnt2d uv = feet.ValueOfUV(here.Value(), kRounding * diameter);
            GeomLProp_SLProps there(surface, uv.X(), uv.Y(), 1, kRounding);
            if (!(here.Value().Distance(there.Value()) <= kCopied * diameter) ||
                !there.IsNormalDefined() || !here.IsNormalDefined() ||
                there.Normal() * here.Normal() <= 0.0) {
                return false;
            }
        }
    }
    return true;
}

std::optional<HoleTrace> trace_on(const Handle<Geom_Surface>& surface, const Hole& hole) {
    Walk walk(surface, hole.diameter);
    HoleTrace result;
    for (const RibbonLoop& loop : hole.loops) {
        auto trace = trace_of(walk, loop);
        if (!trace) {
            return std::nullopt;
        }
        if (!result.empty()) {
            const Eigen::Vector2d middle = middle_of(*trace);
            const Eigen::Vector2d shift =
                walk.in_period(middle, middle_of(result.front())) - middle;
            for (auto& side : *trace) {
                for (Eigen::Vector2d& uv : side) {
                    uv += shift;
                }
            }
        }
        result.push_back(std::move(*trace));
    }
    return result;
}

/// Seams and poles are laid out on the B-spline.
bool has_sides_alone(const Patch& patch) {
    return std::ranges::all_of(patch.wires, [](const std::vector<EdgeUse>& wire) {
        return std::ranges::all_of(
            wire, [](const EdgeUse& use) { return use.loop >= 0 && !use.pole_after; });
    });
}

/// The surfaces that a patch may be a copy of: the one that it was made from, those around it.
std::vector<Handle<Geom_Surface>> surfaces_for(const Patch& patch,
                                               const std::vector<BoundaryLoop>& loops) {
    std::vector<Handle<Geom_Surface>> surfaces;
    if (patch.original) {
        surfaces.push_back(patch.original->surface);
    }
    for (const BoundaryLoop& loop : loops) {
        for (const BoundaryEdge& edge : loop.edges) {
            if (!edge.face.IsNull()) {
                surfaces.push_back(BRep_Tool::Surface(edge.face));
            }
        }
    }
    return surfaces;
}

std::optional<OwnForm> find_form(const Patch& patch, const std::vector<BoundaryLoop>& loops,
                                 const Hole& hole) {
    std::vector<Handle<Geom_Surface>> known;
    Handle<Geom_Surface> spline;
    for (const Handle<Geom_Surface>& surface : surfaces_for(patch, loops)) {
        auto kind = kind_of(surface);
        if (!kind || std::ranges::find(known, surface) != known.end()) {
            continue;
        }
        known.push_back(surface);
        if (spline.IsNull()) {
            const auto made = occ::to_occ(patch.surface);
            if (!made) {
                return std::nullopt;
            }
            spline = *made;
        }
        if (!is_copy(spline, surface, hole.diameter)) {
            continue;
        }
        if (auto trace = trace_on(surface, hole)) {
            return OwnForm{std::move(*kind), occ::cast<Geom_Surface>(surface->Copy()),
                           std::move(*trace)};
        }
    }
    return std::nullopt;
}

}  // namespace

std::optional<OwnForm> own_form_of(const Patch& patch, const std::vector<BoundaryLoop>& loops,
                                   const Hole& hole) {
    if (!std::holds_alternative<SplineSurface>(patch.surface) || !has_sides_alone(patch)) {
        return std::nullopt;
    }
    // Where OCCT fails here the B-spline is as good.
    return occ::guarded("finding a neighbour's own surface",
                        [&] { return find_form(patch, loops, hole); })
        .value_or(std::nullopt);
}

}  // namespace suture

#include "suture/choose/twin_figures.h"

#include "suture/check/fill_measures.h"
#include "suture/occ/convert.h"
#include "suture/occ/guard.h"

#include <BRep_Tool.hxx>
#include <GeomAPI_ProjectPointOnCurve.hxx>
#include <Geom_Curve.hxx>
#include <TopoDS.hxx>

#include <algorithm>
#include <array>

namespace suture {
namespace {

/// A side of the hole lies on an edge of the twin to within this share of the hole's diameter.
constexpr double kOnEdge = 1e-3;

/// Where along a side that is looked at.
constexpr std::array<double, 3> kAlong = {0.2, 0.5, 0.8};

double distance(const TopoDS_Edge& edge, const gp_Pnt& point) {
    double first = 0.0;
    double last = 0.0;
    const occ::Handle<Geom_Curve> curve = BRep_Tool::Curve(edge, first, last);
    if (curve.IsNull()) {
        return INFINITY;
    }
    const GeomAPI_ProjectPointOnCurve foot(point, curve, first, last);
    return foot.NbPoints() > 0 ? foot.LowerDistance() : INFINITY;
}

/// The edge of the face on which a side of the hole lies once the face is laid onto the lost one;
/// a null edge where there is none.
TopoDS_Edge edge_along(const Ribbon& side, const TopoDS_Face& face, const Eigen::Isometry3d& back,
                       double limit) {
    for (const TopoDS_Edge& edge : occ::edges_of(face)) {
        if (std::ranges::all_of(kAlong, [&](double s) {
                return distance(edge, occ::to_point(back * side.at(s).point)) <= limit;
            })) {
            return edge;
        }
    }
    return {};
}

TwinFigures figures_of(const FillMeasures& measures) {
    TwinFigures figures;
    for (const EdgeContinuity& edge : measures.sides) {
        const bool between_two = edge.samples > 0 && edge.faces[0] != 0 && edge.faces[1] != 0;
        figures.angles.push_back(
            between_two ? std::optional(AngleRange{edge.min_angle, edge.max_angle}) : std::nullopt);
    }
    figures.folds = std::ranges::any_of(measures.folds, [](const FaceFold& fold) {
        return fold.verdict == FoldVerdict::Fold && !fold.backwards;
    });
    return figures;
}

}  // namespace

std::optional<TwinFigures> measure_twin(const Site& site, const Hole& hole,
                                        const TwinSource& source, const Progress& progress) {
    if (site.numbering == nullptr) {
        return std::nullopt;
    }
    const auto figures = occ::guarded("measuring a congruent face", [&]() -> Result<TwinFigures> {
        const TopoDS_Face face = TopoDS::Face(site.numbering->faces(source.face));
        const occ::Numbering numbering(site.shape);
        const Eigen::Isometry3d back = source.onto.inverse();
        FillPlace place;
        place.faces.push_back(numbering.of(face));
        for (const RibbonLoop& loop : hole.loops) {
            for (const Ribbon& side : loop.ribbons) {
                const TopoDS_Edge edge = edge_along(side, face, back, kOnEdge * hole.diameter);
                place.sides.push_back(edge.IsNull() ? 0 : numbering.of(edge));
            }
        }
        const auto measures = measure_fills(site.shape, numbering, {place}, Profile(), progress);
        if (!measures) {
            return tl::unexpected(measures.error());
        }
        return figures_of(measures->front());
    });
    return figures ? std::optional(*figures) : std::nullopt;
}

}  // namespace suture

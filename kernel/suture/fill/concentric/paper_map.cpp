#include "suture/fill/concentric/paper_map.h"

#include "suture/fill/concentric/basic.h"
#include "suture/fill/concentric/certificate.h"
#include "suture/fill/concentric/medial.h"
#include "suture/fill/concentric/sites.h"

#include <vector>

namespace suture::concentric {
namespace {

/// The angle under which a chord of a parabola is seen from the vertex.
constexpr double kWidestChord = 0.05;

/// How often the polygon is refined for the axis to move onto: knots in the middles of all spans.
constexpr int kRefinements = 3;

/// Of the refined polygon's axis, branches that stand out less go: seams of its many flat corners.
constexpr double kSalience = 0.05;

ClosedSpline refined(ClosedSpline curve) {
    for (int k = 0; k < kRefinements; ++k) {
        std::vector<double> middles;
        for (std::size_t i = 1; i < curve.knots.size(); ++i) {
            if (curve.knots[i] > curve.knots[i - 1]) {
                middles.push_back(0.5 * (curve.knots[i - 1] + curve.knots[i]));
            }
        }
        curve = with_knots(curve, middles);
    }
    return curve;
}

}  // namespace

Result<ConcentricMap> paper_map(const ClosedSpline& curve, PaperAxis kind) {
    const auto sites = make_sites(curve.poles, nodal_parameters(curve), curve.period());
    if (!sites) {
        return tl::unexpected(sites.error());
    }
    const auto axis = medial_axis(*sites, kWidestChord);
    if (!axis) {
        return tl::unexpected(axis.error());
    }
    ConcentricMap map;
    map.refined = curve;
    map.axis = basic_axis(*axis, *sites);
    for (const MedialNode& node : axis->nodes) {
        map.radius = std::max(map.radius, node.radius);
    }
    if (kind == PaperAxis::Moved) {
        MapOptions options;
        options.salience = kSalience;
        const auto fine = concentric_map(refined(curve), options);
        if (!fine) {
            return tl::unexpected(fine.error());
        }
        map.axis = moved_onto(map.axis, fine->axis);
    }
    const std::vector<int> folded = folded_courses(BoundaryPieces(curve), map.axis);
    if (!folded.empty()) {
        const Course where = courses(map.axis)[static_cast<std::size_t>(folded.front())];
        return fail(
            ErrorCode::Refused, "the paper's map folds between s = {:.6g} and {:.6g}{}", where.from,
            where.to,
            folded.size() > 1 ? fmt::format(" and at {} other places", folded.size() - 1) : "");
    }
    return map;
}

}  // namespace suture::concentric

#include "suture/fill/recognise/describe.h"
#include "suture/fill/recognise/form.h"
#include "suture/fill/recognise/propose.h"
#include "suture/fill/recognise/surface_foot.h"

#include <memory>

namespace suture::recognise {

std::vector<Proposal> propose_candidates(const Border& border, const FillOptions& options,
                                         Refusals& refusals) {
    std::vector<Proposal> proposals;
    if (!options.candidates) {
        return proposals;
    }
    for (const Candidate& candidate : options.candidates()) {
        const bool same = candidate.kind == kSameSurface;
        extend::Locate locate;
        Agreement agreement;
        if (closed_form(candidate.surface)) {
            agreement = measure(border.to_local(candidate.surface), border);
        } else {
            const auto foot =
                std::make_shared<const SurfaceFoot>(std::get<SplineSurface>(candidate.surface));
            locate = [foot](const Ribbon& ribbon, double s) {
                return foot->find(ribbon.at(s).point);
            };
            agreement =
                measure([&](const Eigen::Vector3d& point) { return foot->foot(point); }, border);
        }
        // A side may be sharp on a surface that a face lies on; a moved one has to be tangent.
        const Evidence evidence{same, candidate.allowed / border.size, candidate.chance,
                                candidate.twin.has_value()};
        if (const auto believed = believe(agreement, border, evidence); !believed) {
            refusals.add(candidate.from, believed.error().message);
            continue;
        }
        Recognised what = describe(candidate.surface, agreement, border);
        what.from = candidate.from;
        what.twin = candidate.twin;
        proposals.push_back({candidate.surface,
                             locate,
                             agreement,
                             std::move(what),
                             {candidate.from},
                             0.0,
                             candidate.kind,
                             candidate.original});
    }
    return proposals;
}

}  // namespace suture::recognise

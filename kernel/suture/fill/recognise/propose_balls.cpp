#include "suture/fill/recognise/ball.h"
#include "suture/fill/recognise/describe.h"
#include "suture/fill/recognise/propose.h"
#include "suture/fill/recognise/surface_foot.h"

#include <algorithm>
#include <cmath>
#include <memory>

namespace suture::recognise {
namespace {

/// Pairs of sides between which a ball is tried.
constexpr std::size_t kBalls = 3;

/// How near a ball's envelope is fitted, as a share of the hole's diameter.
constexpr double kArcError = 1e-8;

}  // namespace

std::vector<Proposal> propose_balls(const Border& border, Refusals& refusals) {
    std::vector<Proposal> proposals;
    const std::vector<BallGuess> guesses = guess_balls(border);
    Border judged = border;
    judged.noise = std::max(border.noise, kArcError);
    for (std::size_t k = 0; k < std::min(kBalls, guesses.size()); ++k) {
        for (const auto& [radius, chance] : radii_for(guesses[k], border)) {
            const auto arcs = ball_surface(guesses[k], radius, border, kArcError * border.size);
            if (!arcs) {
                refusals.add("rolling ball", arcs.error().message);
                continue;
            }
            const auto foot = std::make_shared<const SurfaceFoot>(arcs->surface);
            const Agreement agreement =
                measure([&](const Eigen::Vector3d& point) { return foot->foot(point); }, judged);
            const Evidence evidence{/*of_model=*/false, 0.0, chance};
            if (const auto believed = believe(agreement, judged, evidence); !believed) {
                refusals.add("rolling ball", believed.error().message);
                continue;
            }
            const auto locate = [foot](const Ribbon& ribbon, double s) {
                return foot->find(ribbon.at(s).point);
            };
            proposals.push_back({arcs->surface,
                                 locate,
                                 agreement,
                                 describe_ball(std::abs(radius), agreement, border),
                                 {},
                                 arcs->error});
            break;
        }
        if (!proposals.empty() && proposals.back().agreement.gap <= alike(border)) {
            break;
        }
    }
    return proposals;
}

}  // namespace suture::recognise

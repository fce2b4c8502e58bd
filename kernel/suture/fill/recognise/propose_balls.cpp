#include "suture/fill/recognise/chain.h"
#include "suture/fill/recognise/describe.h"
#include "suture/fill/recognise/propose.h"
#include "suture/fill/recognise/surface_foot.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <set>

namespace suture::recognise {
namespace {

/// Pairs of sides between which a ball is tried.
constexpr std::size_t kBalls = 3;

/// How near a ball's envelope is fitted, as a share of the hole's diameter.
constexpr double kArcError = 1e-8;

/// What is believed of one ball, with the first radius that is.
class BallProposals {
  public:
    using Envelope = std::function<Result<ArcSurface>(double radius)>;

    BallProposals(const Border& border, Refusals& refusals)
        : border_(border), judged_(border), refusals_(refusals) {
        judged_.noise = std::max(border.noise, kArcError);
    }

    void add(const BallGuess& guess, std::size_t neighbours, const Envelope& envelope) {
        for (const auto& [radius, chance] : radii_for(guess, border_)) {
            const auto arcs = envelope(radius);
            if (!arcs) {
                refusals_.add("rolling ball", arcs.error().message);
                continue;
            }
            const auto foot = std::make_shared<const SurfaceFoot>(arcs->surface);
            const Agreement agreement =
                measure([&](const Eigen::Vector3d& point) { return foot->foot(point); }, judged_);
            const Evidence evidence{/*of_model=*/false, 0.0, chance};
            if (const auto believed = believe(agreement, judged_, evidence); !believed) {
                refusals_.add("rolling ball", believed.error().message);
                continue;
            }
            const auto locate = [foot](const Ribbon& ribbon, double s) {
                return foot->find(ribbon.at(s).point);
            };
            found_.push_back({arcs->surface,
                              locate,
                              agreement,
                              describe_ball(std::abs(radius), neighbours, agreement, border_),
                              {},
                              arcs->error});
            return;
        }
    }

    [[nodiscard]] std::vector<Proposal>& found() { return found_; }

  private:
    const Border& border_;
    Border judged_;
    Refusals& refusals_;
    std::vector<Proposal> found_;
};

/// The sides that a chain touches.
std::size_t sides_of(const std::vector<BallGuess>& chain) {
    std::set<std::size_t> sides;
    for (const BallGuess& link : chain) {
        sides.insert(link.sides, link.sides + 2);
    }
    return sides.size();
}

}  // namespace

std::vector<Proposal> propose_balls(const Border& border, Refusals& refusals) {
    BallProposals balls(border, refusals);
    const double accuracy = kArcError * border.size;
    const std::vector<BallGuess> guesses = guess_balls(border);
    for (std::size_t k = 0; k < std::min(kBalls, guesses.size()); ++k) {
        balls.add(guesses[k], 2, [&](double radius) {
            return chain_surface({guesses[k]}, radius, border, accuracy);
        });
        if (!balls.found().empty() && balls.found().back().agreement.gap <= alike(border)) {
            break;
        }
    }
    const std::vector<BallGuess> chain = find_chain(guesses, border);
    if (balls.found().empty() && chain.size() > 1) {
        balls.add(chain.front(), sides_of(chain),
                  [&](double radius) { return chain_surface(chain, radius, border, accuracy); });
    }
    return std::move(balls.found());
}

}  // namespace suture::recognise

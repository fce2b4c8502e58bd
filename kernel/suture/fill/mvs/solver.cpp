#include "suture/fill/mvs/solver.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace suture::mvs {
namespace {

// Less damping lets the parametrisation wander, which costs steps and gains no shape.
constexpr double kLeastDamping = 1e-2;
// Damping grows and falls by this factor; so many times in a row, then the iteration is stuck.
constexpr double kDampingFactor = 10.0;
constexpr int kAttempts = 10;
// Gain against prediction: above, the model may be trusted further; below, less.
constexpr double kGoodRatio = 0.5;
constexpr double kPoorRatio = 0.25;
// Changes of the objective by less than this part of it are rounding.
constexpr double kRounding = 1e-12;

struct Step {
    Net net;
    double ratio;  // gain against prediction
};

// The step with one damping; nothing where it does not descend.
std::optional<Step> attempt(const System& system, const Net& net, const System::Linearised& now,
                            double damping) {
    BlockBand factor = now.matrix;
    factor.add(system.damping(), damping * system.weights().energy);
    if (!factor.factorise()) {
        return std::nullopt;
    }
    const Eigen::VectorXd change = factor.solve(-now.gradient);
    Net moved = net;
    moved.poles += Eigen::Map<const Eigen::Matrix3Xd>(change.data(), 3, net.poles.cols());
    const double gain = now.objective - system.objective(moved);
    const double predicted =
        -(now.gradient.dot(change) + 0.5 * change.dot(now.matrix.times(change)));
    if (std::abs(gain) <= kRounding * now.objective) {
        return Step{std::move(moved), 1.0};
    }
    if (!(gain > 0.0)) {
        return std::nullopt;
    }
    return Step{std::move(moved), gain / predicted};
}

}  // namespace

Convergence minimise(const System& system, Net& net, const SolverOptions& options,
                     const Progress& progress) {
    Convergence result;
    double damping = options.damping;
    while (result.steps < options.steps && !result.settled && !progress.cancelled()) {
        const System::Linearised now = system.linearise(net);
        std::optional<Step> step;
        for (int k = 0; k < kAttempts && !step; ++k) {
            step = attempt(system, net, now, damping);
            if (!step) {
                damping *= kDampingFactor;
            }
        }
        if (!step) {
            return result;
        }
        if (step->ratio > kGoodRatio) {
            damping = std::max(damping / kDampingFactor, kLeastDamping);
        } else if (step->ratio < kPoorRatio) {
            damping *= kDampingFactor;
        }
        result.last_move = system.normal_move(net, step->net);
        result.settled = result.last_move < options.settled;
        net = std::move(step->net);
        ++result.steps;
    }
    return result;
}

}  // namespace suture::mvs

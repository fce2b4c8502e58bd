#include "suture/fill/mvs/solver.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace suture::mvs {
namespace {

// Less damping lets the parametrisation wander, which costs steps and gains no shape.
constexpr double kLeastDamping = 1e-2;
// Damping grows and falls by this factor. A step that does not descend is tried again with more,
// by a factor that itself grows: four times cover ten powers of ten. Then the iteration is stuck.
constexpr double kDampingFactor = 10.0;
constexpr int kAttempts = 5;
// Gain against prediction: above, the model may be trusted further; below, less.
constexpr double kGoodRatio = 0.5;
constexpr double kPoorRatio = 0.25;
// This near to its prediction, a step was one of a linear problem.
constexpr double kLinear = 0.1;
// Changes of the objective by less than this part of it are rounding, and so are those by less than
// this against its root: residuals are differences of positions of size 1.
constexpr double kRounding = 1e-12;
constexpr double kRoundingOfRoot = 1e-15;

struct Step {
    Net net;
    double gain = 0.0;
    double ratio = 1.0;  // gain against prediction
    double left = 0.0;   // what another step of this damping would gain, by the linear model
};

// The step with one damping; nothing where it does not descend.
std::optional<Step> attempt(const System& system, const Net& net, const System::Linearised& now,
                            double damping) {
    const double weight = damping * system.weights().energy;
    BlockBand factor = now.matrix;
    factor.add_per_component(system.damping(), weight);
    if (!factor.factorise()) {
        return std::nullopt;
    }
    const Eigen::VectorXd change = factor.solve(-now.gradient);
    Net moved = net;
    moved.poles += change.reshaped(3, net.poles.cols());
    const double gain = now.objective - system.objective(moved);
    // (matrix + weight * damping) * change = -gradient; what the damping held back is the gradient
    // of the linear model after the step.
    const Eigen::MatrixX3d moves = change.reshaped(3, net.poles.cols()).transpose();
    const Eigen::Matrix3Xd held = weight * system.damping().times(moves).transpose();
    const Eigen::VectorXd rest = held.reshaped();
    const double predicted = 0.5 * (change.dot(rest) - now.gradient.dot(change));
    if (std::abs(gain) <= kRounding * now.objective + kRoundingOfRoot * std::sqrt(now.objective)) {
        return Step{std::move(moved)};
    }
    if (!(gain > 0.0)) {
        return std::nullopt;
    }
    return Step{std::move(moved), gain, gain / predicted, 0.5 * rest.dot(factor.solve(rest))};
}

}  // namespace

Convergence minimise(const System& system, Net& net, const SolverOptions& options,
                     const Progress& progress) {
    Convergence result;
    double damping = options.damping;
    const BlockBand& alike = system.damping();
    const double factorising = BlockBand::work(alike.blocks(), 3 * alike.size(), alike.width());
    while (result.steps < options.steps && !result.settled && !progress.cancelled()) {
        const System::Linearised now = system.linearise(net);
        result.work += system.linearising_work();
        const double tried = damping;
        std::optional<Step> step;
        double factor = kDampingFactor;
        for (int k = 0; k < kAttempts && !step; ++k) {
            step = attempt(system, net, now, damping);
            result.work += factorising;
            if (!step) {
                damping *= factor;
                factor *= kDampingFactor;
            }
        }
        if (!step) {
            return result;
        }
        // What was too little for this step would be for the next.
        if (step->ratio > kGoodRatio && damping == tried) {
            damping = std::max(damping / kDampingFactor, kLeastDamping);
        } else if (step->ratio < kPoorRatio) {
            damping *= kDampingFactor;
        }
        result.last_move = system.normal_move(net, step->net);
        result.settled = result.last_move < options.settled ||
                         (std::abs(step->ratio - 1.0) < kLinear &&
                          step->left < options.least_gain * (now.objective - step->gain));
        net = std::move(step->net);
        ++result.steps;
    }
    return result;
}

}  // namespace suture::mvs

#include "suture/fill/mvs/fairing.h"

#include "suture/fill/mvs/solver.h"
#include "suture/fill/mvs/system.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace suture::mvs {
namespace {

// The first net: spans along the longer side of the box, and at least across it. Where the surface
// found from it misses a neighbour by the poor angle, the hole has features smaller than a span,
// and a second attempt starts from the fine one.
constexpr int kFirstSpans = 6;
constexpr int kFineFirstSpans = 12;
constexpr double kPoorAngle = radians(1.0);
constexpr int kLeastSpans = 4;
// Room around the layout: trimming curves on the border of the box would not survive rounding.
constexpr double kMargin = 0.05;
// Spans are not halved below this part of the box: readers of the file project curves onto the
// surface, and lose their way among spans that are much longer than wide.
constexpr double kLeastSpan = 1.0 / 120.0;
// Poles in one direction at most.
constexpr int kMostPoles = 40;
constexpr int kLevels = 10;
// Times that islands and inner points are laid out again before the exact functional counts.
constexpr int kRelayed = 2;
// Samples a span, and on a side at least; as many again, and more, to measure between them.
constexpr double kSamplesPerSpan = 5.0;
constexpr int kLeastSamples = 8;
constexpr double kMeasuredPerSpan = 8.0;
constexpr int kLeastMeasured = 20;

// The goals at the boundary, in the solver's unit: a part of what is asked for, since the file's
// own curves add to it, but never finer than is useful.
constexpr double kGapPart = 0.2;
constexpr double kLeastGap = 1e-6;
constexpr double kMostGap = 1e-5;
constexpr double kAnglePart = 0.1;
constexpr double kCurvaturePart = 0.1;
// A net of more poles need not reach the goals, but only what is well within the tolerances.
constexpr int kCheapPoles = 400;
constexpr double kGoodEnough = 0.4 / kAnglePart;
// A level that brings the worst sample less than this factor nearer brought nothing. So many such
// levels in a row end it, fewer where the surface is far off; the first, where the tolerances hold
// with some room.
constexpr double kProgress = 0.8;
constexpr int kPatience = 3;
constexpr int kPoorPatience = 2;
constexpr double kWithin = 0.8 / kAnglePart;

int patience(double missed_by, bool poor) {
    return missed_by <= kWithin ? 1 : poor ? kPoorPatience : kPatience;
}

// Spans are halved where a sample misses its goal, and by this part of the worst miss.
constexpr double kMarked = 0.3;
// While the surface is this far off it is no small correction of the final one: all spans that miss
// are halved, and the energy keeps its weight.
constexpr double kRoughlyMarked = 0.05;

// Rough, without curvatures: the flat energy holds the parametrisation, and a few steps reach the
// solution from anywhere. Exact: the flat energy is but a damping. Fine: the boundary decides.
constexpr Weights kRough = {1e-8, 1.0, 1e-8, 0.03, 0.0};
constexpr Weights kExact = {1e-8, 1e-6, 1e-8, 0.03, 1e-3};
constexpr Weights kFine = {1e-10, 1e-6, 1e-8, 0.03, 1e-5};
// The energy's weight falls with every level: what misses the boundary last are corners at which
// the energy would like to round the neighbours' disagreement. Less than the least is rounding.
constexpr double kEnergyFactor = 0.01;
constexpr double kLeastEnergy = 1e-13;
constexpr SolverOptions kRoughSteps = {5, 3e-3, 0.0, 1e-2};
constexpr SolverOptions kExactSteps = {8, 2e-6, 0.0002, 1e-1};
constexpr SolverOptions kFineSteps = {3, 3e-6, 0.05, 1.0};

struct Goal {
    double gap, angle, curvature;
    [[nodiscard]] double missed_by(const Miss& miss, const BoundarySample& sample) const {
        return std::max({miss.gap / gap, miss.angle / (angle + sample.unmet_angle),
                         miss.curvature / curvature});
    }
};

// The unit is the diameter of the circle as long as the boundary: unlike the bounding box it does
// not depend on how the hole is turned in space.
Scale scale_of(const RibbonLoop& loop, const Layout& layout) {
    Scale scale;
    scale.length = std::accumulate(layout.lengths.begin(), layout.lengths.end(), 0.0) / kPi;
    for (const Ribbon& ribbon : loop.ribbons) {
        scale.centre += ribbon.at(0.0).point + ribbon.at(0.5).point;
    }
    scale.centre /= 2.0 * static_cast<double>(loop.ribbons.size());
    return scale;
}

Net first_net(const Layout& layout, const Scale& scale, int longer_spans) {
    const Eigen::Vector2d size = (layout.upper - layout.lower) / scale.length;
    const double longer = size.maxCoeff();
    const Eigen::Vector2d margin = Eigen::Vector2d::Constant(kMargin * longer);
    const Eigen::Vector2d lower = layout.lower / scale.length - margin;
    const Eigen::Vector2d upper = layout.upper / scale.length + margin;
    const auto axis = [&](int c) {
        const int spans = static_cast<int>(std::ceil(longer_spans * size[c] / longer));
        return uniform_axis(lower[c], upper[c], std::max(kLeastSpans, spans));
    };
    return {axis(0), axis(1), {}};
}

class Levels {
  public:
    Levels(const Hole& hole, const Layout& layout, const Scale& scale, const FillOptions& options,
           int first_spans)
        : hole_(hole), scale_(scale), options_(options) {
        domain_.loops.push_back(layout);
        const Tolerance& t = options.tolerance;
        goal_.gap = std::clamp(kGapPart * t.linear / scale.length, kLeastGap, kMostGap);
        goal_.angle = kAnglePart * t.angular;
        goal_.curvature = kCurvaturePart * t.curvature;
        net_ = first_net(layout, scale, first_spans);
    }

    [[nodiscard]] Result<Fairing> run();

  private:
    void measure();
    [[nodiscard]] bool good_enough() const;
    [[nodiscard]] std::pair<Axis, Axis> finer(double limit) const;
    [[nodiscard]] bool refine();
    [[nodiscard]] System system(const Weights& weights) const;
    void lay_inside();
    void sample_densely() {
        measured_ = sample_boundary(hole_, domain_, scale_,
                                    {net_.u, net_.v, kMeasuredPerSpan, kLeastMeasured}, false);
    }
    void solve(const System& system, const SolverOptions& steps) {
        steps_ += minimise(system, net_, steps, options_.progress).steps;
    }

    const Hole& hole_;
    Domain domain_;
    Scale scale_;
    const FillOptions& options_;
    Goal goal_{};
    Net net_;
    std::vector<BoundarySample> measured_;
    std::vector<Miss> misses_;
    double missed_by_ = 0.0;
    bool poor_ = false;
    int steps_ = 0;
};

// Islands and inner points lie at their feet on a surface that does not know them yet, and then on
// those that do.
void Levels::lay_inside() {
    if (hole_.loops.size() == 1 && hole_.through.empty()) {
        return;
    }
    Hole outer;
    outer.loops = {hole_.loops.front()};
    const auto boundary = [&](const Hole& hole, bool ends) {
        return sample_boundary(hole, domain_, scale_,
                               {net_.u, net_.v, kSamplesPerSpan, kLeastSamples}, ends);
    };
    const System alone(net_.u, net_.v, polygons_of(boundary(outer, false)), boundary(outer, true),
                       kRough);
    net_ = alone.start();
    solve(alone, kRoughSteps);
    lay_on_surface(net_, scale_, hole_, domain_);
    for (int k = 0; k < kRelayed; ++k) {
        sample_densely();
        const System together = system(kRough);
        net_ = together.start();
        solve(together, kRoughSteps);
        lay_on_surface(net_, scale_, hole_, domain_);
    }
}

System Levels::system(const Weights& weights) const {
    const Density density{net_.u, net_.v, kSamplesPerSpan, kLeastSamples};
    return System(net_.u, net_.v, polygons_of(measured_),
                  sample_boundary(hole_, domain_, scale_, density, true), weights);
}

bool Levels::good_enough() const {
    return missed_by_ <= (net_.poles.cols() > kCheapPoles ? kGoodEnough : 1.0);
}

void Levels::measure() {
    misses_.clear();
    missed_by_ = 0.0;
    poor_ = false;
    for (const BoundarySample& sample : measured_) {
        misses_.push_back(miss(net_, sample));
        poor_ = poor_ || misses_.back().angle > kPoorAngle;
        missed_by_ = std::max(missed_by_, goal_.missed_by(misses_.back(), sample));
    }
}

void keep_least_spans(const Axis& axis, std::vector<bool>& marked) {
    const double least = kLeastSpan * (axis.knots.back() - axis.knots.front());
    for (int k = 0; k < axis.spans(); ++k) {
        if (axis.upper(k) - axis.lower(k) < 2.0 * least) {
            marked[static_cast<std::size_t>(k)] = false;
        }
    }
}

// The net with the spans halved through which the boundary is missed by more than this.
std::pair<Axis, Axis> Levels::finer(double limit) const {
    std::vector<bool> u(static_cast<std::size_t>(net_.u.spans()), false);
    std::vector<bool> v(static_cast<std::size_t>(net_.v.spans()), false);
    for (std::size_t k = 0; k < measured_.size(); ++k) {
        if (goal_.missed_by(misses_[k], measured_[k]) > limit) {
            u[static_cast<std::size_t>(net_.u.span_of(measured_[k].uv.x()))] = true;
            v[static_cast<std::size_t>(net_.v.span_of(measured_[k].uv.y()))] = true;
        }
    }
    keep_least_spans(net_.u, u);
    keep_least_spans(net_.v, v);
    return {halved(net_.u, u), halved(net_.v, v)};
}

// Halves spans where that is needed most. False where none is left to halve, or even the worst take
// too many poles.
bool Levels::refine() {
    for (double part = poor_ ? kRoughlyMarked : kMarked; part < 1.0; part *= 2.0) {
        const auto [u, v] = finer(std::max(1.0, part * missed_by_));
        if (u.count() + v.count() == net_.u.count() + net_.v.count()) {
            return false;
        }
        if (std::max(u.count(), v.count()) <= kMostPoles) {
            net_ = mvs::refine(net_, u, v);
            return true;
        }
    }
    return false;
}

Result<Fairing> Levels::run() {
    lay_inside();
    sample_densely();
    System first = system(kRough);
    net_ = first.start();
    solve(first, kRoughSteps);
    first.set_weights(kExact);
    solve(first, kExactSteps);
    measure();
    Weights weights = kFine;
    const auto relay = [&] { lay_on_surface(net_, scale_, hole_, domain_); };
    Net best = net_;
    Domain best_domain = domain_;
    double least = missed_by_;
    for (int level = 1, idle = 0;
         level < kLevels && !good_enough() && idle < patience(least, poor_); ++level) {
        options_.progress(static_cast<double>(level) / kLevels, "fairing");
        if (!refine()) {
            break;
        }
        relay();
        sample_densely();
        solve(system(weights), kFineSteps);
        measure();
        idle = missed_by_ > kProgress * least ? idle + 1 : 0;
        if (missed_by_ < least) {
            least = missed_by_;
            best = net_;
            best_domain = domain_;
        }
        weights.energy = std::max(kEnergyFactor * weights.energy, kLeastEnergy);
    }
    net_ = best;
    domain_ = best_domain;
    sample_densely();
    if (options_.progress.cancelled()) {
        return fail(ErrorCode::Cancelled, "cancelled after {} steps", steps_);
    }
    Fairing result{
        net_,   scale_, worst_miss(net_, measured_), regularity(net_, polygons_of(measured_)),
        steps_, domain_};
    return result;
}

}  // namespace

Result<Fairing> fair(const Hole& hole, const Layout& layout, const FillOptions& options) {
    const Scale scale = scale_of(hole.loops.front(), layout);
    Result<Fairing> coarse = Levels(hole, layout, scale, options, kFirstSpans).run();
    if (!coarse || coarse->worst.angle < kPoorAngle) {
        return coarse;
    }
    Result<Fairing> fine = Levels(hole, layout, scale, options, kFineFirstSpans).run();
    return fine && fine->worst.angle < coarse->worst.angle ? fine : coarse;
}

}  // namespace suture::mvs

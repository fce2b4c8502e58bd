#include "suture/fill/mvs/levels.h"

#include "suture/fill/mvs/jumps.h"
#include "suture/fill/mvs/outside.h"

#include <algorithm>
#include <cmath>

namespace suture::mvs {
namespace {

Net first_net(const Layout& layout, const std::vector<KnotLine>& lines, const Scale& scale,
              const Schedule& schedule, int longer_spans) {
    const Eigen::Vector2d size = (layout.upper - layout.lower) / scale.length;
    const double longer = size.maxCoeff();
    const Eigen::Vector2d margin = Eigen::Vector2d::Constant(schedule.margin * longer);
    const Eigen::Vector2d lower = layout.lower / scale.length - margin;
    const Eigen::Vector2d upper = layout.upper / scale.length + margin;
    const auto axis = [&](int c) {
        const auto spans = static_cast<int>(std::ceil(longer_spans * size[c] / longer));
        const double width = (upper[c] - lower[c]) / std::max(schedule.least_spans, spans);
        return lined_axis(lower[c], upper[c], width, c, lines);
    };
    return {axis(0), axis(1), {}};
}

}  // namespace

double Levels::Goal::missed_by(const Miss& miss, const BoundarySample& sample) const {
    return std::max(tangency_missed_by(miss, sample),
                    miss.curvature / (curvature + sample.unmet_curvature));
}

double Levels::Goal::tangency_missed_by(const Miss& miss, const BoundarySample& sample) const {
    return std::max(miss.gap / gap, miss.angle / (angle + sample.unmet_angle));
}

Levels::Levels(const Hole& hole, const LinedLayout& layout, const Scale& scale,
               const FillOptions& options, const Schedule& schedule, int first_spans,
               double most_work)
    : hole_(hole),
      all_lines_(layout.lines),
      options_(options),
      schedule_(schedule),
      scale_(scale),
      net_(first_net(layout.layout, {}, scale, schedule, first_spans)),
      lined_(first_net(layout.layout, layout.lines, scale, schedule, first_spans)),
      most_work_(most_work) {
    domain_.loops.push_back(layout.layout);
    const Tolerance& t = options.tolerance;
    goal_.gap = std::clamp(schedule.gap_part * t.linear / scale.length, schedule.least_gap,
                           schedule.most_gap);
    goal_.angle = schedule.angle_part * t.angular;
    goal_.curvature = schedule.curvature_part * t.curvature;
}

void Levels::sample_densely() {
    measured_ =
        sample_boundary(hole_, domain_, scale_,
                        {net_.u, net_.v, schedule_.measured_per_span, schedule_.least_measured},
                        /*ends=*/false);
}

void Levels::solve(const System& system, const SolverOptions& steps) {
    const Convergence found = minimise(system, net_, steps, options_.progress);
    steps_ += found.steps;
    work_ += found.work;
    variation_ = system.variation(net_);
}

Weights Levels::with_lines(Weights weights) const {
    weights.jump = lines_.empty() ? 0.0 : schedule_.jump;
    return weights;
}

// Islands and inner points lie at their feet on a surface that does not know them yet, and then on
// those that do.
void Levels::lay_inside() {
    if (hole_.loops.size() == 1 && hole_.through.empty()) {
        return;
    }
    Hole outer;
    outer.loops = {hole_.loops.front()};
    const auto boundary = [&](const Hole& hole, bool ends) {
        return sample_boundary(
            hole, domain_, scale_,
            {net_.u, net_.v, schedule_.samples_per_span, schedule_.least_samples}, ends);
    };
    const System alone(net_.u, net_.v, polygons_of(boundary(outer, false)), boundary(outer, true),
                       lines_, with_lines(schedule_.rough));
    net_ = alone.start();
    solve(alone, schedule_.rough_steps);
    lay_on_surface(net_, scale_, hole_, domain_);
    for (int k = 0; k < schedule_.relayed; ++k) {
        sample_densely();
        const System together = system(with_lines(schedule_.rough));
        net_ = together.start();
        solve(together, schedule_.rough_steps);
        lay_on_surface(net_, scale_, hole_, domain_);
    }
}

System Levels::system(const Weights& weights) const {
    const double per_span =
        lines_.empty() ? schedule_.samples_per_span : schedule_.samples_per_span_with_lines;
    const Density density{net_.u, net_.v, per_span, schedule_.least_samples};
    return System(net_.u, net_.v, polygons_of(measured_),
                  sample_boundary(hole_, domain_, scale_, density, /*ends=*/true), lines_, weights);
}

bool Levels::good_enough(double missed_by) const {
    const bool large = net_.poles.cols() > schedule_.cheap_poles;
    return missed_by <= (large ? schedule_.good_enough / schedule_.angle_part : 1.0);
}

// Among nets that meet the boundary the one across whose lines the curvature jumps least, unless
// that is bought with a rougher surface.
bool Levels::better_than(const Best& best) const {
    if (good_enough(missed_by_) && good_enough(best.missed_by) && jump_ != best.jump) {
        return jump_ < best.jump && variation_ < schedule_.rougher * best.variation;
    }
    return missed_by_ < best.missed_by;
}

bool Levels::brings(const Best& best) const {
    return good_enough(best.missed_by)
               ? better_than(best) && jump_ <= schedule_.progress * best.jump
               : missed_by_ <= schedule_.progress * best.missed_by;
}

Levels::Best Levels::now() const {
    return {net_, domain_, misses_, missed_by_, jump_, variation_, poor_};
}

void Levels::go_back_to(const Best& best) {
    net_ = best.net;
    domain_ = best.domain;
    misses_ = best.misses;
    missed_by_ = best.missed_by;
    jump_ = best.jump;
    variation_ = best.variation;
    poor_ = best.poor;
    sample_densely();
}

int Levels::patience(const Best& best) const {
    const bool jumps = best.jump > schedule_.visible_jump;
    const bool within = best.missed_by <= schedule_.within / schedule_.angle_part;
    return within && !jumps ? 1 : poor_ ? schedule_.poor_patience : schedule_.patience;
}

bool Levels::affordable() const {
    const double step = BlockBand::work(net_.v.count(), 3 * net_.u.count(), kDegree);
    return work_ + schedule_.steps_ahead * step <= most_work_;
}

// Numbers that are none would pass every comparison below.
Result<void> Levels::expect_finite() const {
    for (const BoundarySample& sample : measured_) {
        const bool finite = sample.point.allFinite() && sample.normal.allFinite() &&
                            (sample.continuity < Continuity::G1 || sample.inward.allFinite()) &&
                            (sample.continuity < Continuity::G2 || sample.curvature.allFinite());
        if (sample.loop >= 0 && !finite) {
            const Ribbon& ribbon = hole_.loops[static_cast<std::size_t>(sample.loop)]
                                       .ribbons[static_cast<std::size_t>(sample.ribbon)];
            return fail(ErrorCode::Refused,
                        "{}: no finite point, normal, tangent across and curvature at {:.3f}",
                        name_of(ribbon), sample.s);
        }
    }
    if (!net_.poles.allFinite()) {
        return fail(ErrorCode::Refused, "the net of {} x {} poles is not finite after {} steps",
                    net_.u.count(), net_.v.count(), steps_);
    }
    return {};
}

double Levels::largest_bend() const {
    double largest = 0.0;
    for (const BoundarySample& sample : measured_) {
        largest = std::max(largest, sample.curvature.norm());
    }
    return largest;
}

Result<void> Levels::measure() {
    if (auto finite = expect_finite(); !finite) {
        return finite;
    }
    misses_.clear();
    missed_by_ = 0.0;
    poor_ = false;
    for (const BoundarySample& sample : measured_) {
        misses_.push_back(miss(net_, sample));
        poor_ = poor_ || misses_.back().angle > schedule_.poor_angle;
        missed_by_ = std::max(missed_by_, goal_.missed_by(misses_.back(), sample));
    }
    jump_ = lines_.empty()
                ? 0.0
                : largest_jump(net_, lines_, polygons_of(measured_), schedule_.seen_from) /
                      largest_bend();
    return {};
}

void Levels::keep_least_spans(const Axis& axis, std::vector<bool>& marked) const {
    const double part = lines_.empty() ? schedule_.least_span : schedule_.least_span_with_lines;
    const double least = part * (axis.knots.back() - axis.knots.front());
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
bool Levels::refine(double least) {
    const int most = lines_.empty() ? schedule_.most_poles : schedule_.most_poles_with_lines;
    for (double part = poor_ ? schedule_.roughly_marked : schedule_.marked; part < 1.0;
         part *= 2.0) {
        const auto [u, v] = finer(std::max(least, part * missed_by_));
        if (u.count() + v.count() == net_.u.count() + net_.v.count()) {
            return false;
        }
        if (std::max(u.count(), v.count()) <= most) {
            net_ = mvs::refine(net_, u, v);
            return true;
        }
    }
    return false;
}

// Knot lines matter beside the boundary only: the fair shape is found without them.
void Levels::draw_lines() {
    net_ = interpolated(net_, lined_.u, lined_.v);
    lines_ = all_lines_;
    sample_densely();
    solve(system(with_lines(schedule_.exact)), schedule_.lined_steps);
}

// The fair shape on the first net; the weights with which the levels begin.
Result<Weights> Levels::begin() {
    lay_inside();
    sample_densely();
    System first = system(with_lines(schedule_.rough));
    net_ = first.start();
    solve(first, schedule_.rough_steps);
    first.set_weights(with_lines(schedule_.exact));
    solve(first, schedule_.exact_steps);
    if (auto measured = measure(); !measured) {
        return tl::unexpected(measured.error());
    }
    if (all_lines_.empty()) {
        return schedule_.fine;
    }
    draw_lines();
    if (auto measured = measure(); !measured) {
        return tl::unexpected(measured.error());
    }
    Weights weights = schedule_.fine_with_lines;
    weights.jump = schedule_.jump;
    return weights;
}

Result<void> Levels::solve_level(const Weights& weights) {
    lay_on_surface(net_, scale_, hole_, domain_);
    sample_densely();
    solve(system(weights), lines_.empty() ? schedule_.fine_steps : schedule_.lined_steps);
    return measure();
}

Result<Fairing> Levels::run() {
    Result<Weights> weights = begin();
    if (!weights) {
        return tl::unexpected(weights.error());
    }
    const bool lined = !lines_.empty();
    const int levels = lined ? schedule_.levels_with_lines : schedule_.levels;
    double least_energy = lined ? schedule_.least_energy_with_lines : schedule_.least_energy;
    Best best = now();
    bool exhausted = false;
    for (int level = 1, idle = 0; level < levels && idle < patience(best); ++level) {
        options_.progress(static_cast<double>(level) / levels, "fairing");
        const bool good = good_enough(missed_by_);
        if (good && jump_ <= schedule_.visible_jump) {
            break;
        }
        if (good && idle == 0) {
            weights->jump *= schedule_.jump_factor;
        } else if (!refine(good ? 0.0 : 1.0)) {
            break;
        }
        exhausted = !affordable();
        if (exhausted) {
            break;
        }
        if (auto solved = solve_level(*weights); !solved) {
            return tl::unexpected(solved.error());
        }
        const bool noisy = lined && level == 1 && variation_ > schedule_.noisy * best.variation;
        if (noisy) {
            go_back_to(best);
            weights->energy = schedule_.fine.energy;
            least_energy = schedule_.least_energy_of_noisy;
            continue;
        }
        idle = brings(best) ? 0 : idle + 1;
        if (better_than(best)) {
            best = now();
        }
        weights->energy = std::max(schedule_.energy_factor * weights->energy, least_energy);
    }
    go_back_to(best);
    return finish(exhausted);
}

Result<Fairing> Levels::finish(bool exhausted) {
    settle_outside(polygons_of(measured_), net_);
    if (auto measured = measure(); !measured) {
        return tl::unexpected(measured.error());
    }
    double tangency = 0.0;
    for (std::size_t k = 0; k < measured_.size(); ++k) {
        tangency = std::max(tangency, goal_.tangency_missed_by(misses_[k], measured_[k]));
    }
    if (options_.progress.cancelled()) {
        return fail(ErrorCode::Cancelled, "cancelled after {} steps", steps_);
    }
    return Fairing{net_,
                   scale_,
                   worst_miss(net_, measured_),
                   missed_by_ * schedule_.angle_part,
                   tangency * schedule_.angle_part,
                   regularity(net_, polygons_of(measured_)),
                   steps_,
                   work_,
                   exhausted,
                   lines_.size(),
                   domain_,
                   {}};
}

}  // namespace suture::mvs

#pragma once

#include "suture/base/result.h"
#include "suture/fill/fill.h"
#include "suture/fill/mvs/domain.h"
#include "suture/fill/mvs/fairing.h"
#include "suture/fill/mvs/knot_lines.h"
#include "suture/fill/mvs/measure.h"
#include "suture/fill/mvs/schedule.h"
#include "suture/fill/mvs/system.h"

#include <utility>
#include <vector>

namespace suture::mvs {

/// One way from a coarse net to finer ones, until the boundary is met: a rough fair shape first,
/// then the exact functional, then knots where the boundary is missed.
class Levels {
  public:
    /// Input    first_spans: along the longer side of the first net's box; most_work: no level
    ///          begins that would take more multiplications in all. What is referred to has to
    ///          outlive this.
    Levels(const Hole& hole, const LinedLayout& layout, const Scale& scale,
           const FillOptions& options, const Schedule& schedule, int first_spans, double most_work);

    /// Refuses  ribbons and nets that are not finite; when cancelled.
    [[nodiscard]] Result<Fairing> run();

  private:
    /// What is asked for at the boundary, in the solver's unit.
    struct Goal {
        double gap = 0.0, angle = 0.0, curvature = 0.0;
        [[nodiscard]] double missed_by(const Miss& miss, const BoundarySample& sample) const;
        [[nodiscard]] double tangency_missed_by(const Miss& miss,
                                                const BoundarySample& sample) const;
    };

    /// The best net so far.
    struct Best {
        Net net;
        Domain domain;
        std::vector<Miss> misses;
        double missed_by = 0.0;
        double jump = 0.0;
        double variation = 0.0;
        bool poor = false;
    };

    [[nodiscard]] Result<Weights> begin();
    [[nodiscard]] Result<void> solve_level(const Weights& weights);
    [[nodiscard]] Result<Fairing> finish(bool exhausted);
    [[nodiscard]] Result<void> measure();
    [[nodiscard]] Result<void> expect_finite() const;
    [[nodiscard]] bool good_enough(double missed_by) const;
    [[nodiscard]] bool better_than(const Best& best) const;
    [[nodiscard]] bool brings(const Best& best) const;
    [[nodiscard]] Best now() const;
    void go_back_to(const Best& best);
    [[nodiscard]] double largest_bend() const;
    [[nodiscard]] bool affordable() const;
    [[nodiscard]] int patience(const Best& best) const;
    [[nodiscard]] std::pair<Axis, Axis> finer(double limit) const;
    void keep_least_spans(const Axis& axis, std::vector<bool>& marked) const;
    [[nodiscard]] bool refine(double least);
    [[nodiscard]] System system(const Weights& weights) const;
    [[nodiscard]] Weights with_lines(Weights weights) const;
    void lay_inside();
    void draw_lines();
    void sample_densely();
    void solve(const System& system, const SolverOptions& steps);

    const Hole& hole_;
    const std::vector<KnotLine>& all_lines_;
    std::vector<KnotLine> lines_;  // none, until they are drawn
    const FillOptions& options_;
    const Schedule& schedule_;
    Scale scale_;
    Domain domain_;
    Goal goal_;
    Net net_;
    Net lined_;  // the first one with lines, without poles
    std::vector<BoundarySample> measured_;
    std::vector<Miss> misses_;
    double missed_by_ = 0.0;
    double jump_ = 0.0;       // across knot lines, against the neighbours' largest curvature
    double variation_ = 0.0;  // of curvature
    bool poor_ = false;
    int steps_ = 0;
    double most_work_ = 0.0;
    double work_ = 0.0;
};

}  // namespace suture::mvs

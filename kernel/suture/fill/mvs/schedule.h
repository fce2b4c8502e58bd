#pragma once

#include "suture/base/tolerance.h"
#include "suture/fill/mvs/solver.h"
#include "suture/fill/mvs/system.h"

namespace suture::mvs {

/// Every number by which the levels of a fill were tuned, in one place: fill_mvs takes others, for
/// tests and for sweeps.
struct Schedule {
    // The first net: spans along the longer side of the box, and at least across it. Where the
    // surface found from it misses a neighbour by the poor angle, the hole has features smaller
    // than a span, and a second attempt starts from the fine one.
    int first_spans = 6;
    int fine_first_spans = 12;
    double poor_angle = radians(1.0);
    int least_spans = 4;
    // Room around the layout: trimming curves on the border of the box would not survive rounding.
    double margin = 0.05;
    // Spans are not halved below this part of the box: readers of the file project curves onto the
    // surface, and lose their way among spans that are much longer than wide.
    double least_span = 1.0 / 120.0;
    double least_span_with_lines = 1.0 / 240.0;
    // Poles in one direction at most; a knot line of C1 takes three more than a simple knot.
    int most_poles = 40;
    int most_poles_with_lines = 80;
    int levels = 10;
    int levels_with_lines = 16;
    // Times that islands and inner points are laid out again before the exact functional counts.
    int relayed = 2;
    // Samples a span, and on a side at least; as many again, and more, to measure between them.
    // A span beside a knot line has more freedom of its own.
    double samples_per_span = 5.0;
    double samples_per_span_with_lines = 7.0;
    int least_samples = 8;
    double measured_per_span = 8.0;
    int least_measured = 20;

    // The goals at the boundary, in the solver's unit: a part of what is asked for, since the
    // file's own curves add to it, but not finer than rounding lets a boundary be met, nor coarser
    // than keeps the shape.
    double gap_part = 0.2;
    double least_gap = 1e-8;
    double most_gap = 1e-5;
    double angle_part = 0.1;
    double curvature_part = 0.1;
    // A net of more poles need not reach the goals, but only this part of the tolerances.
    int cheap_poles = 400;
    double good_enough = 0.4;
    // A level that brings the worst sample less than this factor nearer brought nothing. So many
    // such levels in a row end it, fewer where the surface is far off; the first, where this part
    // of the tolerances holds.
    double progress = 0.8;
    int patience = 3;
    int poor_patience = 2;
    double within = 0.8;
    // Multiplications of an attempt, about: 1e10 take a second. A net with knot lines may take so
    // much of that, one without the rest; a level begins where so many steps of it are affordable.
    double most_work = 1e11;
    double share_of_lines = 0.75;
    double steps_ahead = 1.0;
    // Attempts with curvature along sides that may give it up get so much each, the last one, with
    // tangency alone, all of it: it is as good as if nobody had asked for curvature.
    double share_of_curvature = 0.5;
    // Spans are halved where a sample misses its goal, and by this part of the worst miss; while
    // the surface is far off it is no small correction of the final one, and more spans are.
    double marked = 0.3;
    double roughly_marked = 0.05;

    // Rough, without curvatures: the flat energy holds the parametrisation, and a few steps reach
    // the solution from anywhere. Exact: the flat energy is but a damping. Fine: the boundary
    // decides.
    Weights rough = {1e-8, 1.0, 1e-8, 0.03, 0.0};
    Weights exact = {1e-8, 1e-6, 1e-8, 0.03, 1e-3};
    Weights fine = {1e-10, 1e-6, 1e-8, 0.03, 1e-5};
    Weights fine_with_lines = {1e-14, 1e-6, 1e-8, 0.03, 1e-5};
    // The energy's weight falls with every level: what misses the boundary last are corners at
    // which the energy would like to round the neighbours' disagreement. Less than the least is
    // rounding.
    double energy_factor = 0.01;
    double least_energy = 1e-13;
    // With knot lines no corner needs rounding, and the boundary decides from the first level on.
    // Where the curvature then varies so many times as much as that of the fair shape, it is the
    // neighbours' noise that is followed: the weight begins anew like without lines, and falls to
    // the last of these.
    double least_energy_with_lines = 1e-18;
    double noisy = 200.0;
    double least_energy_of_noisy = 1e-16;
    SolverOptions rough_steps = {5, 3e-3, 0.0, 1e-2};
    SolverOptions exact_steps = {8, 2e-6, 0.0002, 1e-1};
    SolverOptions fine_steps = {3, 3e-6, 0.05, 1.0};
    // Beside knot lines the parametrisation is free span by span, and needs more to hold it.
    SolverOptions lined_steps = {3, 3e-6, 0.05, 1e2};

    // Curvature that is asked for may make gap and angle worse by this factor, where they are out
    // of tolerance.
    double curvature_price = 1.1;

    // A corner gets knot lines where without them the smallest spans would miss by this part of the
    // angle asked for.
    double twisted = 0.5;
    // How much the jump of curvature across a line counts against the energy. Where the boundary is
    // met, it counts by this factor more, and the net is refined by turns, as long as it jumps in
    // the middle by more than this part of the neighbours' largest curvature; in the middle is what
    // is so far from the boundary, in the solver's unit. A net on which the curvature varies by so
    // much more is no better.
    double jump = 1e4;
    double jump_factor = 10.0;
    double visible_jump = 0.02;
    double seen_from = 0.1;
    double rougher = 2.0;
};

}  // namespace suture::mvs

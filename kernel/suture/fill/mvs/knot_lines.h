#pragma once

#include "suture/fill/mvs/layout.h"
#include "suture/fill/mvs/net.h"
#include "suture/fill/mvs/samples.h"
#include "suture/model/ribbon.h"

#include <vector>

namespace suture::mvs {

/// A line u = at (axis 0) or v = at (axis 1) across which the net is C1 only. It is there for
/// corners of the hole whose neighbours agree in normal but not in curvature: no C2 surface is
/// tangent to both along their edges.
struct KnotLine {
    /// Where the line meets such a corner, along the line, and how far its freedom reaches.
    struct Origin {
        double along, reach;
    };
    int axis = 0;
    double at = 0.0;
    std::vector<Origin> origins;

    /// Of the jump of curvature across the line at t: 0 at the corners, 1 out of their reach.
    [[nodiscard]] double weight(double t) const;
};

/// A layout turned so that lines of the net serve its twisted corners best, and these lines, in the
/// solver's unit. No corner needs any: the layout as it was.
struct LinedLayout {
    Layout layout;
    std::vector<KnotLine> lines;
    double twist = 0.0;  ///< the largest disagreement at such a corner, in the solver's unit
};

/// Input    least_twist: the disagreement of the neighbours' second fundamental forms, in the
///          solver's unit, from which on a corner gets lines.
/// Source   docs/methods/mvs.md, "knot lines".
[[nodiscard]] LinedLayout with_knot_lines(const RibbonLoop& loop, const Layout& layout,
                                          const Scale& scale, double least_twist);

/// The axis between two ends with the lines that cross it, uniform in between with spans of about
/// this width.
[[nodiscard]] Axis lined_axis(double lower, double upper, double width, int axis,
                              const std::vector<KnotLine>& lines);

/// The jumps across a line of the second derivative, and of the third times the shorter adjacent
/// span, as functionals of the six coefficients from `first` on.
struct JumpRow {
    int first = 0;
    Eigen::Matrix<double, 2, kOrder> values;
};
[[nodiscard]] JumpRow jump_row(const Axis& axis, double at);

}  // namespace suture::mvs

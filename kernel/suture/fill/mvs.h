#pragma once

#include "suture/fill/fill.h"

namespace suture {

namespace mvs {
struct Schedule;
}

/// The minimum-variation fill: the one biquintic B-spline surface that meets all neighbours and
/// whose curvature varies least, integral of |grad II|^2. Spheres and cylinders come back as they
/// were, everything else as the fairest surface there is. It is C4, but C1 across knot lines
/// through corners at which no smoother surface is tangent to both neighbours.
///
/// Input     options.own: "work", how much it may compute; 1, where it is not given, for about ten
///           seconds.
/// Result    one patch; trims[l][i] is where ribbon i of loop l runs in its domain. Loops after the
///           first are islands, hole.through are points to pass through.
/// Promises  deterministic; the surface is regular on the trimmed domain and faces the neighbours'
///           way, both measured before return. The notes say what was reached at the boundary.
/// Refuses   a side of zero length or with an unbounded normal; a loop that crosses itself; an
///           iteration that does not settle; a surface that folds.
/// Source    Moreton & Sequin, Functional optimization for fair surface design, SIGGRAPH 1992; the
///           scheme is our own: docs/methods/mvs.md.
[[nodiscard]] Result<FillResult> fill_mvs(const Hole& hole, const FillOptions& options);

/// The same with other numbers than those it is tuned to.
[[nodiscard]] Result<FillResult> fill_mvs(const Hole& hole, const FillOptions& options,
                                          const mvs::Schedule& schedule);

}  // namespace suture

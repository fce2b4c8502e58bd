#pragma once

#include "suture/base/result.h"
#include "suture/fill/fill.h"
#include "suture/fill/mvs/domain.h"
#include "suture/fill/mvs/layout.h"
#include "suture/fill/mvs/measure.h"
#include "suture/fill/mvs/net.h"
#include "suture/fill/mvs/samples.h"

namespace suture::mvs {

/// The surface of least variation of curvature over a laid-out boundary.
struct Fairing {
    Net net;                  ///< in the solver's unit
    Scale scale;              ///< from that unit to the model's
    Miss worst;               ///< at the boundary, between the samples that were fitted
    double regularity = 0.0;  ///< least area element on the trimmed domain, against the mean
    int steps = 0;
    Domain domain;  ///< where every loop runs
};

/// From a coarse net to finer ones, until the boundary is met: a rough fair shape first, then the
/// exact functional, then knots where the boundary is missed.
///
/// Refuses  cancelled by the user; an iteration that finds no descent from its start.
[[nodiscard]] Result<Fairing> fair(const Hole& hole, const Layout& layout,
                                   const FillOptions& options);

}  // namespace suture::mvs

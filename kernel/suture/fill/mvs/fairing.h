#pragma once

#include "suture/base/result.h"
#include "suture/fill/fill.h"
#include "suture/fill/mvs/domain.h"
#include "suture/fill/mvs/layout.h"
#include "suture/fill/mvs/measure.h"
#include "suture/fill/mvs/net.h"
#include "suture/fill/mvs/samples.h"

#include <cstddef>
#include <string>
#include <vector>

namespace suture::mvs {

struct Schedule;

/// The surface of least variation of curvature over a laid-out boundary.
struct Fairing {
    Net net;                          ///< in the solver's unit
    Scale scale;                      ///< from that unit to the model's
    Miss worst;                       ///< at the boundary, between the samples that were fitted
    double missed_by = 0.0;           ///< the largest miss against what is asked for; 1: just met
    double tangency_missed_by = 0.0;  ///< of gap and angle alone
    double regularity = 0.0;  ///< least signed area element on the trimmed domain, against the mean
    int steps = 0;
    double work = 0.0;       ///< multiplications, about
    bool exhausted = false;  ///< ended because more would have been too much work
    std::size_t lines = 0;   ///< knot lines of C1
    Domain domain;           ///< where every loop runs
    /// Sides that asked for curvature and got tangency, for the sake of gap and angle: edge
    /// numbers.
    std::vector<std::string> tangent_only;
};

/// The best of a few attempts: with knot lines where corners need them, without, and from a finer
/// net where the first ones leave a side off by more than a degree. Curvature that was asked for is
/// given up along the sides at whose ends no surface has it, or along all, where it costs more of
/// gap or angle than `Schedule::curvature_price`.
///
/// Refuses  cancelled by the user; an iteration that finds no descent from its start.
[[nodiscard]] Result<Fairing> fair(const Hole& hole, const Layout& layout,
                                   const FillOptions& options, const Schedule& schedule);

}  // namespace suture::mvs

#pragma once

#include "suture/base/tolerance.h"
#include "suture/detect/boundary_loop.h"
#include "suture/detect/loop_shape.h"
#include "suture/detect/seams.h"
#include "suture/detect/shell_graph.h"
#include "suture/detect/walk_loops.h"

#include <string>
#include <string_view>
#include <vector>

namespace suture {

/// Turning below which a loop is a hole, and above which it is the rim of a sheet whose area is not
/// much more than what the loop spans; between them the area decides (docs/holes.md).
inline constexpr double kHoleTurning = 0.5 * kPi;
inline constexpr double kRimTurning = kPi;

/// A sheet of less than this many times the area that its loop spans can be a gently curved sheet;
/// a hemisphere has 2.
inline constexpr double kSheetArea = 2.0;

/// A kind and why.
struct Verdict {
    LoopKind kind = LoopKind::Ambiguous;
    double gap = 0.0;
    std::string reason;
};

/// Input  partners: per step of the loop.
[[nodiscard]] Verdict classify_loop(const ShellGraph& graph, const RawLoop& loop,
                                    const LoopShape& shape,
                                    const std::vector<EdgePartner>& partners);

}  // namespace suture

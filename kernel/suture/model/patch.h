#pragma once

#include "suture/model/continuity.h"
#include "suture/model/surface.h"

#include <Eigen/Core>

#include <functional>
#include <string>
#include <vector>

namespace suture {

/// Where a ribbon runs in a patch's domain: (u, v) as a function of the ribbon's own s in [0,1].
using TrimCurve = std::function<Eigen::Vector2d(double s)>;

/// One surface trimmed by the hole's loops.
struct Patch {
    Surface surface;
    bool reversed = false;   ///< the outward normal is -(X_u x X_v)
    bool exact = true;       ///< false where the surface approximates the method's own form
    double fit_error = 0.0;  ///< of that approximation, in model units
    /// trims[l][i]: where ribbon i of loop l runs in the surface's domain; the interior lies to its
    /// left, or to its right where `reversed`.
    std::vector<std::vector<TrimCurve>> trims;
};

/// What a fill method made of a hole.
struct FillResult {
    std::vector<Patch> patches;
    std::vector<std::string> notes;  ///< what the user should know: relaxed corners, chosen counts
};

}  // namespace suture

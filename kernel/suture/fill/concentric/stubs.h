#pragma once

#include "suture/fill/concentric/closed_spline.h"
#include "suture/fill/concentric/concentric_curve.h"

namespace suture::concentric {

/// An axis for a single face, and the side from whose start its seam leads to the axis.
struct Opened {
    ConcentricCurve axis;
    int side = 0;
};

/// The axis that a single face needs. Where c rests over a corner, it gets a stub, a short branch
/// towards that corner: c goes out to its end and back while the boundary passes the corner. So a
/// spoke leads from every corner to a node of its own, and the face is smooth between these spokes.
/// The seam has to end at an end of the axis, else OCCT's STEP reader moves the face's pcurves by a
/// period: where no side starts at one, the side with the most room gets a stub as well.
///
/// Input    sides: of the boundary, on [i, i + 1] each.
/// Result   a curve that is certified wherever `curve` is; a stub that would make the map fold is
///          left out.
[[nodiscard]] Opened with_stubs(const ConcentricCurve& curve, const ClosedSpline& boundary,
                                int sides);

}  // namespace suture::concentric

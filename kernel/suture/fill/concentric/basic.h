#pragma once

#include "suture/fill/concentric/certificate.h"
#include "suture/fill/concentric/concentric_curve.h"
#include "suture/fill/concentric/medial.h"
#include "suture/fill/concentric/sites.h"

#include <vector>

namespace suture::concentric {

/// The concentric axis as the paper has it: every reflex vertex is mapped to the nearest branch
/// point in its range or else to the nearest point of the axis there, which becomes a concentric
/// vertex; then every convex one to the closest concentric vertex along its seam; chords between.
/// What lies between the images of two vertices has parameters interpolated by length. Not
/// certified: on reflex polygons it may fold.
///
/// Source   Martin & Cohen 2003, section 3.1 and figure 7, steps 3 to 5.
[[nodiscard]] ConcentricCurve basic_axis(const MedialAxis& axis, const Sites& sites);

/// The same axis with every node moved to the nearest point of a finer one: its few control points
/// where many have shown that the axis is.
///
/// Source   Martin & Cohen 2003, figure 11.
[[nodiscard]] ConcentricCurve moved_onto(const ConcentricCurve& coarse,
                                         const ConcentricCurve& fine);

/// The courses of the concentric curve that cross the boundary or lie outside of it.
///
/// Input    chords: to each of the boundary's polynomials.
[[nodiscard]] std::vector<int> courses_outside(const BoundaryPieces& boundary,
                                               const ConcentricCurve& curve, int chords = 32);

}  // namespace suture::concentric

#pragma once

#include "suture/fill/concentric/certificate.h"
#include "suture/fill/concentric/concentric_curve.h"

#include <vector>

namespace suture::concentric {

/// The same axis with fewer nodes: those in the middle of a branch go, one by one, where the axis
/// moves by no more than `distance` and the map stays certified. Each node less saves the surface
/// as many rows of poles as its degree.
///
/// Input    keep: parameters at which a stop has to stay.
[[nodiscard]] ConcentricCurve simplified(const ConcentricCurve& curve,
                                         const BoundaryPieces& boundary,
                                         const std::vector<double>& keep, double distance);

}  // namespace suture::concentric

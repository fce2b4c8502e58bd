#pragma once

#include "suture/check/continuity.h"
#include "suture/occ/topology.h"

namespace suture {

/// Measures an edge that one face alone uses: how far its curve is from the face's surface, as gap.
///
/// Input    edge: EdgeN of the numbering, used by one face.
/// Result   faces[1] is 0, angle and curvature too. No samples and a note where OCCT fails.
[[nodiscard]] EdgeContinuity measure_free_edge(int edge, const occ::Numbering& numbering);

}  // namespace suture

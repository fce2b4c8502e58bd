#pragma once

#include "suture/base/progress.h"
#include "suture/base/result.h"
#include "suture/base/tolerance.h"
#include "suture/detect/boundary_loop.h"
#include "suture/model/patch.h"
#include "suture/model/ribbon.h"

#include <string>
#include <vector>

namespace suture {

/// How one side came out, measured between the finished face and the neighbour.
struct SideMeasure {
    double gap = 0.0;
    double angle = 0.0;
    double curvature_mismatch = 0.0;
};

/// A fill as it would be in the model.
struct TrialMeasure {
    std::vector<SideMeasure> sides;  ///< in the order of the loops
    SideMeasure inner;               ///< the largest along the edges between the new faces
    double through = 0.0;            ///< largest distance of an inner point from the new faces
    double score = 0.0;  ///< largest measure over its tolerance, of what each side asked for: <= 1
                         ///< is within tolerance
};

/// Builds a fill's faces on copies of the hole's edges and neighbours and measures them with the
/// continuity check: the model itself stays as it is.
///
/// Refuses  a face that OCCT's BRepCheck does not accept.
[[nodiscard]] Result<TrialMeasure> try_fill(const std::vector<BoundaryLoop>& loops,
                                            const Hole& hole, const FillResult& fill,
                                            const Tolerance& tolerance, const Progress& progress);

/// The score of one side: what it asked for, over the tolerance.
[[nodiscard]] double score_of(const SideMeasure& side, Continuity wanted,
                              const Tolerance& tolerance);

}  // namespace suture

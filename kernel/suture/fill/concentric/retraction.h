#pragma once

#include "suture/base/result.h"
#include "suture/fill/concentric/certificate.h"
#include "suture/fill/concentric/concentric_curve.h"
#include "suture/fill/concentric/medial.h"
#include "suture/fill/concentric/sites.h"

#include <vector>

namespace suture::concentric {

/// The parts of a boundary over which a concentric curve folds.
struct Folds {
    std::vector<Course> where;
};

struct RetractionOptions {
    /// Branches that stick out of the disc at their root by less than this share of the largest
    /// radius are cut; 0 cuts the seams alone.
    double salience = 0.0;
    /// Whether c rests at the axis' ends for all that is mapped there, where it can.
    bool rest_at_tips = false;
};

/// The robust concentric axis: the walk around the medial axis, its seams cut at their first nodes
/// and its branches where they stand out too little, with the parameters at which the map does not
/// fold.
///
/// Every node of a side's cell has the parameter of its foot on the side; a reflex vertex is given
/// a little of its sides' parameters for its own cell. So each piece of c stays in the cell of the
/// piece of the polygon over it, where the spokes c - gamma cannot turn over.
///
/// Input    corners: parameters at which the boundary has corners; where they belong to a seam,
///          they are mapped to its node.
/// Result   a curve that is certified on `boundary`, or the intervals where none was found.
/// Source   Martin & Cohen 2003, section 3.1, Definitions 1 to 3. Deviation: the parameters are the
///          feet's, and are moved until the certificate holds; the paper interpolates them.
[[nodiscard]] tl::expected<ConcentricCurve, Folds> retract(const MedialAxis& axis,
                                                           const Sites& sites,
                                                           const BoundaryPieces& boundary,
                                                           const std::vector<double>& corners,
                                                           const RetractionOptions& options);

}  // namespace suture::concentric

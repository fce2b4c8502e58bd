#pragma once

#include "suture/check/continuity.h"

#include <string>
#include <vector>

namespace suture {

/// Proven upper bounds of gap and angle along an edge, or why there are none.
struct EdgeCertificate {
    int edge = 0;  ///< EdgeN, 1-based
    bool certified = false;
    double gap = 0.0, angle = 0.0;  ///< nowhere on the edge is more; angle in radians
    bool within_slack = false;      ///< both lie as near to what was measured as was wanted
    int stretches = 0;              ///< into which the edge was divided
    std::string reason;             ///< why it is not certified
};

/// Bounds gap and angle along edges, by Taylor models of edge and surfaces whose polynomials are
/// bounded in Bernstein's form; docs/check.md tells how, and what is assumed.
///
/// Input    edges as measured: an edge is divided until its bounds exceed max_gap and max_angle by
///          no more than `slack` of them, or of a fifth of the profile's limit where that is more.
/// Result   a certificate for each edge; one that stays above the wanted slack is valid too,
///          and marked.
/// Refuses  a cancelled run; a slack that is not positive (Usage).
[[nodiscard]] Result<std::vector<EdgeCertificate>> certify_edges(
    const TopoDS_Shape& shape, const std::vector<EdgeContinuity>& edges, const Profile& profile,
    double slack, const Progress& progress);

}  // namespace suture

#pragma once

#include "suture/check/continuity.h"

#include <TopoDS_Shape.hxx>

#include <map>
#include <optional>
#include <vector>

namespace suture {

/// The tolerance of an edge, against what it has to cover.
struct EdgeTolerance {
    int edge = 0;                  ///< EdgeN, 1-based
    double now = 0.0;              ///< its tolerance
    std::optional<double> before;  ///< what it was, where that is known
    double gap = 0.0;              ///< largest distance of its curve from its faces, as measured

    /// By how many times it exceeds the gap, or what it was if that is more; at least 1 counts as
    /// needed. Below `least`, OCCT's smallest tolerance of a file, there is nothing to say.
    [[nodiscard]] double excess(double least) const;
};

/// The tolerances of the edges of some faces (1-based FaceN), by edge number.
///
/// Input   report: measures the edges of these faces; an edge that it lacks is left out, as one
/// that
///         could not be measured. before: of edges by their number in this shape, may be empty.
[[nodiscard]] std::vector<EdgeTolerance> measure_edge_tolerances(
    const TopoDS_Shape& shape, const std::vector<int>& faces, const ContinuityReport& report,
    const std::map<int, double>& before);

}  // namespace suture

#pragma once

#include "suture/base/result.h"
#include "suture/detect/boundary_loop.h"
#include "suture/model/ribbon.h"

#include <string>
#include <vector>

namespace suture {

/// A corner of a hole: where ribbon i - 1 ends and ribbon i begins.
struct Corner {
    Eigen::Vector3d point = Eigen::Vector3d::Zero();
    double angle = 0.0;            ///< inside the hole, between the two sides, radians: pi = smooth
    double normal_mismatch = 0.0;  ///< between the neighbours' normals there, radians
    int face_before = 0;           ///< FaceN of ribbon i - 1's neighbour
    int face_after = 0;            ///< FaceN of ribbon i's neighbour
};

/// The ribbons of a hole: exact evaluation on the neighbours' own surfaces and edges, with their
/// orientations and locations.
///
/// Input    the loops that bound one missing face, longest first.
/// Refuses  an edge without a 3D curve or pcurve, of zero length, or with an unbounded normal.
[[nodiscard]] Result<Hole> extract_hole(const std::vector<BoundaryLoop>& loops);

/// Corners of one loop, corner i at the start of ribbon i.
[[nodiscard]] std::vector<Corner> corners_of(const RibbonLoop& loop);

}  // namespace suture

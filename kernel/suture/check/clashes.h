#pragma once

#include "suture/base/progress.h"
#include "suture/base/result.h"

#include <Eigen/Core>

#include <TopoDS_Shape.hxx>

#include <vector>

namespace suture {

/// Two faces that pass through each other, or one that passes through itself (equal numbers).
struct Clash {
    int face = 0;                                  ///< FaceN, 1-based: one of the faces asked for
    int other = 0;                                 ///< FaceN
    Eigen::Vector3d at = Eigen::Vector3d::Zero();  ///< on both, away from what they share
    double depth = 0.0;  ///< each reaches at least so far beyond the other, on both sides
    double angle = 0.0;  ///< between the two there, radians, at most a right angle
};

/// A face that lies on another one.
struct Overlay {
    int face = 0;        ///< FaceN, 1-based: one of the faces asked for
    int other = 0;       ///< FaceN
    double share = 0.0;  ///< part of the face's area from which the other is nearer than the limit
    double distance = 0.0;    ///< the mean over that part
    bool neighbours = false;  ///< they share an edge
    bool opposed = false;     ///< their outward normals point apart: back on back
    Eigen::Vector3d at = Eigen::Vector3d::Zero();
};

struct ClashReport {
    std::vector<Clash> clashes;     ///< one for each pair of faces, the deepest that was found
    std::vector<Overlay> overlays;  ///< by face
    double resolution = 0.0;        ///< what passes through by less may be missed
};

/// Looks whether faces pass through any other face of a shape, through each other or themselves,
/// and whether they lie on another.
///
/// Trees of boxes around both surfaces give pairs of triangles that meet; from each a point on both
/// surfaces is sought, which counts if it lies inside both faces, away from the edges and vertices
/// that they share, and if both reach farther beyond it, on either side, than the tolerance and the
/// tolerances of the shared edges. Touching is no clash. docs/check.md tells the details.
///
/// Input    faces: FaceN of the shape, 1-based; on_surface: how near is lying on the other. On a
/// face
///          with which it shares an edge a face lies from a twentieth of its width on: it was built
///          on that edge, and a wall that near to its own back is not.
/// Refuses  a null shape, a face that does not exist, limits that are not positive (Usage); a
///          cancelled run. A pair that OCCT cannot evaluate is passed over.
[[nodiscard]] Result<ClashReport> find_clashes(const TopoDS_Shape& shape,
                                               const std::vector<int>& faces, double tolerance,
                                               double on_surface, const Progress& progress);

}  // namespace suture

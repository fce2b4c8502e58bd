#pragma once

#include "suture/base/progress.h"
#include "suture/base/result.h"

#include <Eigen/Core>

#include <TopoDS_Shape.hxx>

#include <vector>

namespace suture {

/// A knot of a face's B-spline surface at which its derivatives may jump, and how much the surface
/// itself does there: measured inside the face, between the limits from both sides of the knot.
struct KnotLine {
    int face = 0;        ///< FaceN, 1-based
    bool is_u = true;    ///< u is constant along the line
    double knot = 0.0;   ///< value of that parameter
    int parametric = 0;  ///< order up to which the parametrisation is smooth: -1, 0 or 1
    int samples = 0;     ///< points inside the face at which it could be measured
    double max_gap = 0.0;
    double max_angle = 0.0;               ///< between the normals of both sides, radians
    double curvature_mismatch = 0.0;      ///< max |k1-k2| / max(|k1|,|k2|), across the line
    double curvature_mismatch_sum = 0.0;  ///< max |k1-k2| / (|k1|+|k2|)
    Eigen::Vector3d at = Eigen::Vector3d::Zero();  ///< where the angle is largest
};

/// The inner knot lines at which the B-spline surfaces of a shape are no more than C1.
///
/// Result   every line with at least one sample inside its face, by face.
/// Refuses  a cancelled run.
[[nodiscard]] Result<std::vector<KnotLine>> measure_face_knots(const TopoDS_Shape& shape,
                                                               const Progress& progress);

}  // namespace suture

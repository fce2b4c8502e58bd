#pragma once

#include "suture/base/result.h"
#include "suture/fill/concentric/closed_spline.h"
#include "suture/model/ribbon.h"
#include "suture/model/surface.h"

#include <vector>

namespace suture::concentric {

/// A hole's loop as B-splines: side i on [i, i + 1].
struct Boundary {
    std::vector<SplineCurve> sides;  ///< in space: the edges' own curves where these are polynomial
    double error = 0.0;              ///< of the others, in model units
    Frame frame;                     ///< z along the area vector: the loop runs counterclockwise
    ClosedSpline planar;             ///< all sides in the frame's x and y, of one degree
    double height = 0.0;             ///< how far the loop leaves the frame's plane
    int highest = 0;                 ///< the side that does

    [[nodiscard]] int count() const { return static_cast<int>(sides.size()); }
    /// The point of the frame's plane.
    [[nodiscard]] Eigen::Vector3d lifted(const Eigen::Vector2d& xy) const {
        return frame.origin + xy.x() * frame.x + xy.y() * frame.y;
    }
    [[nodiscard]] Eigen::Vector3d coordinates(const Eigen::Vector3d& point) const {
        const Eigen::Vector3d d = point - frame.origin;
        return {d.dot(frame.x), d.dot(frame.y), d.dot(frame.z)};
    }
};

/// Input    accuracy: of what is no polynomial (circles, rational curves), in model units.
/// Refuses  a hole with islands; a side that cannot be fitted within ten times the accuracy.
[[nodiscard]] Result<Boundary> boundary_of(const Hole& hole, double accuracy);

}  // namespace suture::concentric

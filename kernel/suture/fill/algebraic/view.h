#pragma once

#include "suture/base/result.h"
#include "suture/fill/algebraic/guide.h"
#include "suture/fill/algebraic/neighbour.h"

#include <Eigen/Core>

#include <functional>
#include <vector>

namespace suture::algebraic {

/// A side's curve in unit coordinates, for s in [0,1].
using UnitCurve = std::function<Eigen::Vector3d(double s)>;

/// Whence a hole is seen so that each ray meets the surface once, and not at a grazing angle; and
/// the point of the surface around which space is divided: it sees all of the boundary.
struct View {
    Eigen::Vector3d centre;
    Eigen::Vector3d outer;
    double sign = 1.0;        ///< +1 if the surface's normals point away from the centre
    bool concurrent = false;  ///< all planes of bent sides meet in the centre
};

/// Result   the point where the planes of all bent sides meet, if it is such a centre, else one far
///          from the hole on the axis of its normals.
/// Refuses  normals that spread so far that there is no such axis; a boundary that no point of the
///          guide sees all of.
[[nodiscard]] Result<View> find_view(const std::vector<UnitCurve>& curves,
                                     const std::vector<SideShape>& shapes,
                                     const std::vector<GuidePoint>& guide);

}  // namespace suture::algebraic

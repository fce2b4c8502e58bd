#pragma once

#include "suture/fill/concentric/boundary.h"
#include "suture/fill/concentric/concentric_curve.h"
#include "suture/model/patch.h"

#include <Eigen/Core>

#include <functional>
#include <optional>
#include <vector>

namespace suture::concentric {

/// What becomes a face: the part of the map over some sides of the hole.
struct Region {
    int first = 0;                ///< side
    int count = 1;                ///< of sides
    SplineCurve side;             ///< the sides as one curve in space on [first, first + count]
    std::vector<Course> courses;  ///< the concentric curve over them
};

/// One region for each side of the hole, or a single one for all of them.
///
/// Input    axis: gets a node where the seam of each corner ends; single: the first side of the
/// only
///          region.
[[nodiscard]] std::vector<Region> regions_of(const Boundary& boundary, ConcentricCurve& axis,
                                             std::optional<int> single);

/// Makes a region's last row of poles, in space, exactly one point where c rests: rounding would
/// give the surface some direction there, and a normal by chance.
///
/// Input    row: a spline with kinks where courses end; vertex: a node in space.
void collapse_rests(SplineCurve& row, const std::vector<Course>& courses,
                    const std::function<Eigen::Vector3d(int node)>& vertex);

/// Faces for the regions, which share their seams and the edges of the axis: a seam leads from each
/// corner of the hole to the axis, and every edge of the axis has a face, or a part of one, on
/// either side.
///
///        node <---- axis ---- node       t = 1
///         |                    ^
///         | seam i      seam i+1         interior
///         v                    |
///      corner i -- side i --> corner i+1   t = 0
///
/// Input    surface: that of a region, with the boundary's parameter as u and t as v; vertex: a
/// node in space.
[[nodiscard]] FillResult assemble(const std::vector<Region>& regions,
                                  const std::function<SplineSurface(const Region&)>& surface,
                                  const std::function<Eigen::Vector3d(int node)>& vertex);

}  // namespace suture::concentric

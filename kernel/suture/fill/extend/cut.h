#pragma once

#include "suture/base/result.h"
#include "suture/fill/extend/region.h"

#include <Eigen/Core>

#include <vector>

namespace suture::extend {

/// Where a patch that goes all the way around its surface is cut open: along a straight line of the
/// domain, which the face uses as an edge twice, from a corner of one loop to a corner of another
/// or to a pole, where the surface shrinks to a point.
///
///           other_corner <---- other_loop -----
///     to +------------------------------------+ to + period
///        |               hole                 |
///   from +------------------------------------+ from + period
///          ------------- loop ---------> corner
struct Seam {
    int loop = 0;
    int corner = 0;       ///< the seam starts where ribbon `corner` of `loop` starts
    int other_loop = -1;  ///< -1: the seam ends in a pole
    int other_corner = 0;
    Eigen::Vector2d from = Eigen::Vector2d::Zero();
    Eigen::Vector2d to = Eigen::Vector2d::Zero();
    Eigen::Vector2d period = Eigen::Vector2d::Zero();  ///< to the seam's other place in the domain
};

/// Cuts a region that goes around the surface open, along a straight line of the domain from corner
/// to corner (or pole) that meets no side. A line of constant `around` is taken where there is one.
///
/// Input    snap: by how far the seam may miss its second corner, in model units.
/// Changes  traces: moved by periods. That of the seam's loop runs from seam.from at the seam's
///          corner to from + period, that of its other loop from to + period to `to`; all others
///          lie between the two places of the seam.
/// Refuses  when no such line exists; a B-spline's is where its own domain begins.
[[nodiscard]] Result<Seam> cut_open(const Chart& chart, const Region& region,
                                    std::vector<Trace>& traces, double snap);

}  // namespace suture::extend

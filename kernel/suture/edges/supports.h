#pragma once

#include "suture/base/result.h"
#include "suture/detect/boundary_loop.h"
#include "suture/occ/handle.h"
#include "suture/occ/topology.h"

#include <Eigen/Core>

#include <Geom_Surface.hxx>
#include <gp_Pnt2d.hxx>

#include <cmath>
#include <map>
#include <vector>

namespace suture {

/// The point of a surface nearest to another.
struct SurfaceFoot {
    double apart = INFINITY;  ///< infinite where there is none
    gp_Pnt2d uv;
    Eigen::Vector3d normal = Eigen::Vector3d::Zero();  ///< X_u x X_v, unit; not finite where none
};
[[nodiscard]] SurfaceFoot foot_of(const Eigen::Vector3d& point,
                                  const occ::Handle<Geom_Surface>& surface);

/// Gives sides the faces that the new one is to be tangent to there, whether or not they have a
/// face of their own. A support is turned so that the border is walked with the new face on the
/// left: where it ends at the edge, the new face is its continuation; where the edge runs inside
/// it, the whole border is walked counterclockwise.
///
/// Input    supports: EdgeN -> FaceN, other borders' edges among them; reach: how far an edge may
///          be from its support, model units.
/// Changes  loops: `support` of their sides.
/// Refuses  (Usage) a face that does not exist; an edge that does not lie on its support: how far
///          it is from it; a support across the opening in which the edge runs inside.
[[nodiscard]] Result<void> lean_on_supports(const occ::Numbering& numbering,
                                            const std::map<int, int>& supports, double reach,
                                            std::vector<BoundaryLoop>& loops);

}  // namespace suture

#pragma once

#include "suture/base/result.h"
#include "suture/detect/boundary_loop.h"
#include "suture/model/ribbon.h"

#include <Eigen/Core>

#include <vector>

namespace suture {

/// The ribbon of an edge without a face, but for its normals: these are set_free_normals' to give.
///
/// Refuses  an edge without a 3D curve.
[[nodiscard]] Result<Ribbon> free_ribbon(const BoundaryEdge& boundary);

/// Gives the sides without a face the normals of a surface that turns as little as it can: carried
/// along the curve from the neighbour at one end to that at the other. Where no side of a loop has
/// a face, normals are those of the opening. What a method makes of them is where it begins; the
/// border itself they do not bind.
///
/// Input    faceless: which ribbons free_ribbon has made; opening: the direction from which the
///          first loop runs counterclockwise.
/// Changes  ribbons: `at` of these.
void set_free_normals(const std::vector<bool>& faceless, const Eigen::Vector3d& opening,
                      std::vector<Ribbon>& ribbons);

}  // namespace suture

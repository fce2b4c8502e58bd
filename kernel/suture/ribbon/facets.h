#pragma once

#include "suture/detect/boundary_loop.h"
#include "suture/model/ribbon.h"

#include <Eigen/Core>

#include <TopoDS_Shape.hxx>

#include <vector>

namespace suture {

/// Whether the faces around a hole are facets: planes with straight edges, many of them, each a
/// little turned against the next, so that a curved shape is meant. Not where the opening is
/// planar: a lid closes it as well.
[[nodiscard]] bool are_facets(const Hole& hole, const std::vector<BoundaryLoop>& loops);

/// Points inside a hole between facets, on the curved shape that the facets mean: a polynomial over
/// the opening's plane, fitted to the vertices of the border and of the facets around it.
///
/// Input    shape: has the facets, and those around them.
/// Result   none where these vertices lie on no such surface: their distances are too large.
[[nodiscard]] std::vector<Eigen::Vector3d> points_between_facets(
    const TopoDS_Shape& shape, const std::vector<BoundaryLoop>& loops, const Hole& hole);

}  // namespace suture

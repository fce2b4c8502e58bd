#pragma once

#include "suture/detect/shell_graph.h"
#include "suture/detect/walk_loops.h"

#include <Eigen/Core>

#include <vector>

namespace suture {

/// A loop as a polygon, walked with the hole on the left, and what is measured of it.
struct LoopShape {
    std::vector<Eigen::Vector3d> points;
    std::vector<Eigen::Vector3d> along;   ///< unit direction of the walk at each point
    std::vector<Eigen::Vector3d> onward;  ///< unit, at right angles to the walk in the tangent
                                          ///< plane of the neighbour: where its surface would go on
    Eigen::Vector3d centre = Eigen::Vector3d::Zero();
    Eigen::Vector3d axis =
        Eigen::Vector3d::Zero();  ///< unit: the walk goes counterclockwise about it
    double length = 0.0;
    double diameter = 0.0;
    double spanned_area = 0.0;  ///< of the cone over the loop from its centre; of a flat
                                ///< loop what it encloses
    double flatness = 0.0;      ///< largest distance of a point from the mean plane
    double turning = 0.0;       ///< seen with the material on the left: 2 pi around a flat disc,
                                ///< -2 pi around a hole in a flat sheet
};

[[nodiscard]] LoopShape measure_loop(const ShellGraph& graph, const RawLoop& loop);

}  // namespace suture

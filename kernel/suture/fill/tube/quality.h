#pragma once

#include "suture/fill/tube/net.h"

#include <Eigen/Core>

#include <vector>

namespace suture::tube {

/// The angle between the normals on the two sides of the line along a column at a double knot.
struct Crease {
    int column = 0;
    double angle = 0.0;
    double u = 0.0;  ///< where it is largest
};
[[nodiscard]] std::vector<Crease> measure_creases(const Net& net);

/// Where the surface turns over.
struct Fold {
    double turn = 0.0;  ///< the largest angle between the normals at neighbouring samples
    double u = 0.0, v = 0.0;
    int interval = 0;
};
/// Normals on a grid in every patch, from the pole's own outwards.
[[nodiscard]] Fold measure_fold(const Net& net, const Eigen::Vector3d& normal);

/// The largest angle between the pole's normal and the surface's on the line u around it.
[[nodiscard]] double pole_deviation(const Net& net, const Eigen::Vector3d& normal, double u);

}  // namespace suture::tube

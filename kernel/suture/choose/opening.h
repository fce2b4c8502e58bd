#pragma once

#include "suture/model/ribbon.h"

#include <Eigen/Core>

#include <utility>

namespace suture {

/// The best plane through the hole's border, turned so that the border runs counterclockwise.
struct Opening {
    Eigen::Vector3d centre = Eigen::Vector3d::Zero();
    Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();
    double height = 0.0;  ///< how far the border leaves the plane, model units
};

[[nodiscard]] Opening opening_of(const Hole& hole);

/// Whether the neighbour lies in the opening itself: a face that continued it would leave the hole
/// across its own border.
[[nodiscard]] bool lies_in_opening(const Ribbon& ribbon, const Opening& opening);

/// The smallest and the largest angle between a side's cross tangents and the opening's plane,
/// radians.
[[nodiscard]] std::pair<double, double> steepness_along(const Ribbon& ribbon,
                                                        const Opening& opening);

}  // namespace suture

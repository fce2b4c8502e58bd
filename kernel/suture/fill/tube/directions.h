#pragma once

#include "suture/model/ribbon.h"

#include <Eigen/Geometry>

#include <cmath>

namespace suture::tube {

/// Whether the face is to be tangent to the side's neighbour.
[[nodiscard]] inline bool joins_smoothly(const Ribbon& ribbon) {
    return ribbon.continuity >= Continuity::G1;
}

/// From 0 to pi, of vectors of any length.
[[nodiscard]] inline double angle_between(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
    return std::atan2(a.cross(b).norm(), a.dot(b));
}

}  // namespace suture::tube

#pragma once

#include <Eigen/Core>

#include <algorithm>
#include <optional>
#include <vector>

namespace suture {

/// A point that a surface has to pass.
struct ThroughPoint {
    Eigen::Vector3d point = Eigen::Vector3d::Zero();
    /// Unit normal that the surface has to have there, either way; none: any.
    std::optional<Eigen::Vector3d> normal = std::nullopt;
};

[[nodiscard]] inline bool any_normal(const std::vector<ThroughPoint>& points) {
    return std::any_of(points.begin(), points.end(),
                       [](const ThroughPoint& point) { return point.normal.has_value(); });
}

}  // namespace suture

#pragma once

#include <Eigen/Core>

#include <vector>

namespace suture::mvs {

/// Where the horizontal line at height v crosses closed polygons (2 x count), from left to right: a
/// point of the line lies inside when an odd number of them lies to its left.
[[nodiscard]] std::vector<double> crossings(const std::vector<Eigen::Matrix2Xd>& polygons,
                                            double v);

/// Whether two sides of a closed polygon in space (3 x count) cross, or pass nearer than `limit`.
[[nodiscard]] bool crosses_in_space(const Eigen::Matrix3Xd& polygon, double limit);

/// Whether a closed polygon crosses itself.
[[nodiscard]] bool crosses_itself(const Eigen::Matrix2Xd& polygon);

}  // namespace suture::mvs

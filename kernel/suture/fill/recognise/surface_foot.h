#pragma once

#include "suture/fill/recognise/agreement.h"
#include "suture/spline/surface.h"

#include <Eigen/Core>

#include <vector>

namespace suture::recognise {

/// Finds the point of a B-spline surface that is nearest to a given one: from the nearest
/// point of a grid by Newton's method. Thread safe.
class SurfaceFoot {
  public:
    /// Input    rows: of the grid, at most, each way.
    explicit SurfaceFoot(const SplineSurface& surface, std::size_t rows = 64);

    /// (u, v), also a little beyond the domain's borders.
    [[nodiscard]] Eigen::Vector2d find(const Eigen::Vector3d& point) const;

    /// Distance and normal there.
    [[nodiscard]] Foot foot(const Eigen::Vector3d& point) const;

  private:
    SplineSurface surface_;
    std::vector<Eigen::Vector2d> parameters_;
    Eigen::Matrix3Xd points_;
    double size_ = 0.0;  ///< of all points

    [[nodiscard]] Eigen::Vector2d polished(const Eigen::Vector3d& point, Eigen::Vector2d uv) const;
};

}  // namespace suture::recognise

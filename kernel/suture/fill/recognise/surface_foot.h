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

    /// (u, v) in the domain; beyond its borders only where there is no foot nearby inside.
    [[nodiscard]] Eigen::Vector2d find(const Eigen::Vector3d& point) const;

    /// Distance and normal there.
    [[nodiscard]] Foot foot(const Eigen::Vector3d& point) const;

  private:
    SplineSurface surface_;
    Eigen::Vector2d low_, width_;  ///< of the domain
    std::vector<Eigen::Vector2d> parameters_;
    Eigen::Matrix3Xd points_;
    double size_ = 0.0;  ///< of all points

    struct Descent {
        Eigen::Vector2d uv;
        bool settled = false;    ///< no step leads nearer
        bool at_border = false;  ///< the point lies beyond
    };
    [[nodiscard]] Eigen::Vector2d polished(const Eigen::Vector3d& point,
                                           const Eigen::Vector2d& uv) const;
    [[nodiscard]] Descent descend(const Eigen::Vector3d& point, Eigen::Vector2d uv,
                                  bool stay) const;
    /// Where the way to the foot leads out of the domain.
    [[nodiscard]] Eigen::Array2<bool> ends_at(const Eigen::Vector2d& uv,
                                              const Eigen::Vector2d& slope) const;
    [[nodiscard]] Eigen::Vector2d placed(const Eigen::Vector2d& uv, bool stay) const;
};

}  // namespace suture::recognise

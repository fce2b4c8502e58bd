#pragma once

#include "suture/base/result.h"
#include "suture/model/ribbon.h"

#include <Eigen/Core>

#include <array>
#include <optional>
#include <vector>

namespace suture::recognise {

/// Where a ball that rolls between two surfaces stands: its centre, and its contacts with both.
struct BallPosition {
    Eigen::Vector3d centre = Eigen::Vector3d::Zero();
    Eigen::Vector3d tangent = Eigen::Vector3d::Zero();  ///< unit, of the path of centres
    std::array<Eigen::Vector3d, 2> normal;              ///< outward, of the two surfaces
    std::array<Eigen::Vector2d, 2> uv;
};

/// A ball of constant radius between two neighbours' own surfaces.
///
///     S1(u1, v1) - r n1 = S2(u2, v2) - r n2,    tangent . (centre - given centre) = 0
///
/// are four equations for four unknowns.
class RollingBall {
  public:
    /// Input    radius: positive where the centre lies inside of both surfaces, in model units.
    RollingBall(const Support& a, const Support& b, double radius) : support_{&a, &b}, r_(radius) {}

    [[nodiscard]] double radius() const { return r_; }

    /// The position in the plane through `centre` across `start`'s tangent; none where Newton's
    /// method does not come to rest.
    [[nodiscard]] std::optional<BallPosition> at(const Eigen::Vector3d& centre,
                                                 const BallPosition& start) const;

    /// The position with these contacts to begin with.
    [[nodiscard]] std::optional<BallPosition> near(const Eigen::Vector2d& uv1,
                                                   const Eigen::Vector2d& uv2) const;

  private:
    const Support* support_[2];
    double r_;

    struct Contact {
        Eigen::Vector3d centre, normal;
        Eigen::Matrix<double, 3, 2> by_uv;  ///< derivative of the centre
    };
    [[nodiscard]] Contact contact(int which, const Eigen::Vector2d& uv) const;
    [[nodiscard]] BallPosition position(const Eigen::Vector2d& uv1,
                                        const Eigen::Vector2d& uv2) const;
};

/// The path of the ball's centres, in positions about `step` apart: from the start both ways until
/// every point of `cover` has its nearest position inside.
///
/// Refuses  a path that ends before, or has no end.
[[nodiscard]] Result<std::vector<BallPosition>> walk(const RollingBall& ball,
                                                     const BallPosition& start, double step,
                                                     const Eigen::Matrix3Xd& cover);

}  // namespace suture::recognise

#pragma once

#include "suture/fill/concentric/boundary.h"
#include "suture/fill/concentric/concentric_curve.h"
#include "suture/fill/concentric/guide.h"
#include "suture/model/ribbon.h"

#include <Eigen/Core>

#include <vector>

namespace suture::concentric {

/// A point of a surface over (s, t) and its derivatives.
struct SpokeJet {
    Eigen::Vector3d point, s, t, st;
};

/// A spoke of the map in the guide's domain, and what the guide misses of the hole's side where it
/// starts.
struct Spoke {
    Eigen::Vector2d from;    ///< in the guide's domain
    Eigen::Vector2d along;   ///< to the axis
    Eigen::Vector3d missed;  ///< of the side's point, in model units
    Eigen::Vector3d bend;    ///< of a slope dF/dt that lies in the neighbour's tangent plane
};

/// What lies on one side and one course: smooth in s.
struct Strip {
    int side = 0;
    Course course;
    double from = 0.0, to = 0.0;
};

/// A spoke and how it changes with s.
struct MovingSpoke {
    Spoke at, change;
};

/// The map carried into space:
///     F(s,t) = X((1-t) gamma + t c) + H0(t) missed(s) + H1(t) bend(s)
/// where X is the guide, gamma the loop in its domain, and H0, H1 the cubics of Hermite that begin
/// with value (slope) 1 and end with value and slope 0. F begins with the hole's sides and their
/// neighbours' tangent planes, and its last derivatives along the axis are the guide's own.
class Spokes {
  public:
    Spokes(const Hole& hole, const Boundary& boundary, const Guide& guide,
           const ConcentricCurve& axis);

    [[nodiscard]] Spoke at(const Strip& strip, double s) const;
    /// At the strip's ends one-sided.
    [[nodiscard]] MovingSpoke moving(const Strip& strip, double s) const;

    [[nodiscard]] Eigen::Vector3d point(const Spoke& spoke, double t) const;
    [[nodiscard]] Eigen::Vector3d slope(const Spoke& spoke, double t) const;
    [[nodiscard]] SpokeJet jet(const MovingSpoke& spoke, double t) const;

    [[nodiscard]] Eigen::Vector3d node(int node) const;

  private:
    const Hole& hole_;
    const Boundary& boundary_;
    const Guide& guide_;
    const ConcentricCurve& axis_;
    /// The bend of the spoke from the corner where side i begins: into the neighbours' common plane
    /// there, zero where they have none.
    std::vector<Eigen::Vector3d> corner_bends_;

    [[nodiscard]] const Ribbon& ribbon(int side) const {
        return hole_.loops.front().ribbons[static_cast<std::size_t>(side)];
    }
    [[nodiscard]] Eigen::Vector3d bend(int side, double s, const Eigen::Vector2d& at,
                                       const Eigen::Vector2d& along) const;
};

}  // namespace suture::concentric

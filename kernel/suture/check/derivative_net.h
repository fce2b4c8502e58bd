#pragma once

#include "suture/check/face_domain.h"
#include "suture/occ/handle.h"

#include <Eigen/Geometry>

#include <Geom_BSplineSurface.hxx>
#include <gp_Trsf.hxx>

#include <array>
#include <vector>

namespace suture {

/// The control net of a B-spline surface, and if it is polynomial those of its first derivatives:
/// over a box each lies in the hull of what acts there.
struct DerivativeNet {
    std::array<int, 2> degrees = {1, 1};
    std::array<std::vector<double>, 2> knots;  ///< with their multiplicities
    int poles_v = 0;
    std::vector<Eigen::Vector3d> poles;       ///< with v fastest
    std::vector<Eigen::Vector3d> by_u, by_v;  ///< the same; none of a rational surface

    /// The box lies within the knots: that of a periodic surface may not.
    [[nodiscard]] bool covers(const ParameterBox& box) const;
    /// Around the surface over a box that it covers.
    [[nodiscard]] Eigen::AlignedBox3d hull(const ParameterBox& box) const;

    /// There are two linear functions of space by which the surface becomes a map of the box whose
    /// derivative has everywhere a positive definite symmetric part: such a map is one to one on a
    /// convex domain, so that the surface does not pass through itself there.
    [[nodiscard]] bool is_monotone(const ParameterBox& box) const;
};

/// The same of a map of a convex domain whose derivatives lie in the hulls of these vectors.
[[nodiscard]] bool is_monotone(const std::vector<Eigen::Vector3d>& by_u,
                               const std::vector<Eigen::Vector3d>& by_v);

/// Of a periodic surface, that of one period.
///
/// Input   location: moves the surface.
[[nodiscard]] DerivativeNet make_derivative_net(const occ::Handle<Geom_BSplineSurface>& surface,
                                                const gp_Trsf& location);

}  // namespace suture

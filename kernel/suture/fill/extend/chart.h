#pragma once

#include "suture/model/ribbon.h"
#include "suture/model/surface.h"

#include <Eigen/Core>

#include <functional>
#include <vector>

namespace suture::extend {

/// A border of a surface's domain that is one point in space: a pole of a sphere, the tip of a
/// cone, a collapsed side of a B-spline.
struct Pole {
    int across = 1;      ///< the coordinate that is constant there: 1 = v
    double value = 0.0;  ///< of that coordinate
    double side = 1.0;   ///< +1: the surface lies below it, -1: above
    double slack = 0.0;  ///< how near to `value` counts as in the pole
};

/// Where a ribbon lies in the domain of a B-spline, up to periods.
using Locate = std::function<Eigen::Vector2d(const Ribbon& ribbon, double s)>;

/// Of a B-spline that is the neighbours' own: as they have it.
[[nodiscard]] Eigen::Vector2d own_parameters(const Ribbon& ribbon, double s);

/// The surface to be continued, and how its domain closes.
struct Chart {
    Surface surface;
    Locate locate;                                     ///< of a B-spline
    Eigen::Vector2d period = Eigen::Vector2d::Zero();  ///< in u, v; 0 where it does not close
    std::vector<Pole> poles;

    /// Where a ribbon lies in the domain, up to periods. In a pole of a closed form: the direction
    /// in which the ribbon leaves or reaches it.
    [[nodiscard]] Eigen::Vector2d uv(const Ribbon& ribbon, double s) const;

    /// The pole in which a point of the domain lies; nullptr: in none.
    [[nodiscard]] const Pole* pole_at(const Eigen::Vector2d& uv) const;
};

/// Input    distance: how far apart points may lie that are one; reach: the hole's size; both in
///          model units.
[[nodiscard]] Chart chart_of(const Surface& surface, double distance, double reach);

/// By component the value nearest to `centre` among value + k period.
[[nodiscard]] Eigen::Vector2d nearest(const Eigen::Vector2d& value, const Eigen::Vector2d& centre,
                                      const Eigen::Vector2d& period);

}  // namespace suture::extend

#pragma once

#include "suture/base/result.h"
#include "suture/model/ribbon.h"

#include <Eigen/Core>

#include <vector>

namespace suture::mvs {

/// Where one ribbon runs in the domain: a polynomial in the ribbon's own s.
class DomainCurve {
  public:
    /// Input: 2 x count Chebyshev coefficients on [0,1].
    explicit DomainCurve(Eigen::Matrix2Xd coefficients);

    [[nodiscard]] Eigen::Vector2d at(double s) const;
    [[nodiscard]] Eigen::Vector2d derivative(double s) const;

    /// The curve under a linear map and then shifted.
    [[nodiscard]] DomainCurve moved(const Eigen::Matrix2d& map, const Eigen::Vector2d& shift) const;

    /// The curve with its ends moved, and in between so that its tangents and curvatures there stay
    /// as they are.
    [[nodiscard]] DomainCurve with_ends_moved(const Eigen::Vector2d& start,
                                              const Eigen::Vector2d& end) const;

  private:
    Eigen::Matrix2Xd coefficients_;
    Eigen::Matrix2Xd derivative_;
};

/// One loop in the domain.
struct DomainLoop {
    std::vector<DomainCurve> curves;  ///< one a ribbon; each ends where the next begins
    std::vector<double> lengths;      ///< of the ribbons in space
};

/// The domain of a fill, in model units.
struct Domain {
    std::vector<DomainLoop> loops;         ///< counterclockwise, then the islands, clockwise
    std::vector<Eigen::Vector2d> through;  ///< of the hole's inner points
};

/// How a boundary was laid out.
enum class LayoutKind {
    Development,  ///< sides and corners turn as they do on the neighbours
    Polygon,      ///< corners turn as they do, sides alike
    Circle,       ///< all turns alike
};

/// A loop laid out in the plane, counterclockwise, with the ribbons' own lengths.
struct Layout : DomainLoop {
    LayoutKind kind = LayoutKind::Development;
    double turning = 0.0;      ///< of the boundary as seen on the neighbours; 2 pi in the plane
    double closing_gap = 0.0;  ///< of the development before it was closed, relative to its length
    bool simple = true;        ///< does not cross itself
    Eigen::Vector2d lower = Eigen::Vector2d::Zero();  ///< its bounding box
    Eigen::Vector2d upper = Eigen::Vector2d::Zero();
};

/// Unrolls the boundary: every side turns in the plane as it turns on its neighbour (geodesic
/// curvature), and so do the corners, plus the one smooth turning that closes the curve at 2 pi
/// with the least change of curvature. Sides that want position only have no neighbour to turn on:
/// there the normals between those of the nearest sides that do, or that of the whole loop, serve.
/// What would cross itself that way is laid out more simply. The box of least area has its longer
/// side along v.
///
/// Refuses  a side of zero length or with an unbounded normal, naming it; a loop that crosses
///          itself in space.
/// Source   docs/methods/mvs.md, "domain".
[[nodiscard]] Result<Layout> lay_out(const RibbonLoop& loop, double diameter);

}  // namespace suture::mvs

#pragma once

#include "suture/base/through_point.h"
#include "suture/model/continuity.h"
#include "suture/model/surface.h"
#include "suture/spline/curve.h"

#include <Eigen/Core>

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace suture {

/// What a hole's side looks like at one parameter.
///
/// The loop is walked with the hole on the left, seen against the neighbour's normal:
///
///                     hole
///                  ^ inward
///                  |
///       corner i --+--> tangent ---- corner i+1
///                  o  normal (towards the reader)
///               neighbour
struct RibbonPoint {
    Eigen::Vector3d point;
    Eigen::Vector3d tangent;  ///< dP/ds for s in [0,1], in model units
    Eigen::Vector3d normal;   ///< unit normal of the neighbour, outward of the shell
    Eigen::Vector3d inward;   ///< unit cross tangent: normal x tangent / |tangent|
    /// Second fundamental form of the neighbour as a symmetric 3 x 3 matrix S with S normal = 0:
    /// II(a, b) = a^T S b for tangent vectors a, b, with the sign of n . X_ij.
    Eigen::Matrix3d curvature;
};

/// The neighbour's own surface.
struct Support {
    Surface surface;
    bool reversed = false;  ///< the outward normal is -(X_u x X_v)
    /// Where the ribbon runs in the surface's domain, for s in [0,1].
    std::function<Eigen::Vector2d(double s)> uv;
};

/// One side of a hole, from corner i (s = 0) to corner i + 1 (s = 1).
struct Ribbon {
    std::function<RibbonPoint(double s)> at;  ///< exact, thread safe
    Continuity continuity = Continuity::G1;   ///< wanted towards the neighbour
    std::optional<Support> support;           ///< the neighbour's surface, if it has a closed form
    std::optional<SplineCurve> curve;  ///< the edge's own curve on [0,1], if it is a polynomial one
    int edge = 0;                      ///< source edge, 1-based as EdgeN
    int face = 0;                      ///< source face, 1-based as FaceN
    /// The curve on its source edge: s runs from the parameter `first` to `last` of the edge's
    /// curve, affinely; first > last where the loop walks the edge backwards.
    double first = 0.0;
    double last = 1.0;
};

/// The sides around one boundary loop, cyclic: ribbon i ends where ribbon i + 1 begins. A loop of
/// one ribbon is a closed edge.
struct RibbonLoop {
    std::vector<Ribbon> ribbons;
};

/// What is missing: one face's worth of boundary. The first loop is the longest; further loops are
/// islands.
struct Hole {
    std::vector<RibbonLoop> loops;
    double diameter = 0.0;   ///< diagonal of the bounding box of all loops, in model units
    double tolerance = 0.0;  ///< the largest tolerance of the model's own edges around the hole
    std::vector<ThroughPoint> through;  ///< points that the surface has to pass
};

/// Names a ribbon as a user knows it: "edge 12 (face 3)".
[[nodiscard]] std::string name_of(const Ribbon& ribbon);

}  // namespace suture

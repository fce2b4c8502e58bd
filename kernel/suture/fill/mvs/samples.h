#pragma once

#include "suture/fill/mvs/layout.h"
#include "suture/fill/mvs/net.h"
#include "suture/model/ribbon.h"

#include <Eigen/Core>

#include <vector>

namespace suture::mvs {

/// Similarity to the unit in which the solver works: the hole about the origin, about 1 across.
struct Scale {
    Eigen::Vector3d centre = Eigen::Vector3d::Zero();
    double length = 1.0;
};

/// What the surface has to do at one boundary point, in the solver's unit.
struct BoundarySample {
    int loop = 0;  ///< -1: an inner point, twice if it has a normal
    int ribbon = 0;
    double s = 0.0;
    double length = 0.0;                           ///< of the boundary for which this sample stands
    Eigen::Vector2d uv = Eigen::Vector2d::Zero();  ///< in the domain
    /// Unit normal of the domain's boundary, inward.
    Eigen::Vector2d across = Eigen::Vector2d::Zero();
    Eigen::Vector3d point = Eigen::Vector3d::Zero();
    Eigen::Vector3d normal = Eigen::Vector3d::Zero();
    Eigen::Vector3d inward = Eigen::Vector3d::Zero();
    Eigen::Matrix3d curvature = Eigen::Matrix3d::Zero();
    Continuity continuity = Continuity::G1;
    /// What no surface can meet here: near a corner at which the neighbours' normals disagree,
    /// half their angle, falling to zero away from it.
    double unmet_angle = 0.0;
    /// The same of curvatures, along a side that asks for curvature.
    double unmet_curvature = 0.0;
    /// How much the curvature that is asked for counts here, 0 to 1: nothing at corners at which no
    /// surface has it, so that it does not cost the tangent plane.
    double curvature_weight = 1.0;
};

/// How densely a boundary is sampled: as finely as the net is divided where it runs.
struct Density {
    const Axis& u;
    const Axis& v;
    double per_span;  ///< samples on the length of a span's shorter side, at least
    int least;        ///< on a side of the hole
};

/// Samples of all loops, and then the inner points. A side is cut into equal pieces, and each of
/// those in halves until it is short enough; samples stand for half of the pieces around them.
/// `ends`: where pieces meet, with the corners; else in the middle of the pieces, for which they
/// stand.
///
/// Where two ribbons do not end in the same point, each bends towards the middle of their ends: a
/// jump would cost the angle there more than the gap that the model has anyway.
[[nodiscard]] std::vector<BoundarySample> sample_boundary(const Hole& hole, const Domain& domain,
                                                          const Scale& scale,
                                                          const Density& density, bool ends);

/// Curvatures that bend a length by angles that differ by less than this are the same.
inline constexpr double kSameBend = 1e-3;

/// A corner of a loop, between ribbon i - 1 and ribbon i.
struct Corner {
    double mismatch = 0.0;  ///< angle between the two normals, 0 where one side wants position only
    /// What the second fundamental forms disagree in where that matters: a side that asks for
    /// curvature fixes the whole form, one that asks for tangency its row along the side.
    double twist = 0.0;
    Eigen::Vector3d point = Eigen::Vector3d::Zero();  ///< in the middle of the two ends
};
[[nodiscard]] std::vector<Corner> corners_of(const RibbonLoop& loop);

}  // namespace suture::mvs

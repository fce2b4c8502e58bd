#pragma once

#include "suture/base/progress.h"
#include "suture/base/result.h"
#include "suture/base/tolerance.h"
#include "suture/fill/algebraic/frustum.h"
#include "suture/fill/algebraic/guide.h"
#include "suture/fill/algebraic/jet_space.h"
#include "suture/fill/algebraic/partition.h"
#include "suture/fill/algebraic/system.h"
#include "suture/fill/algebraic/view.h"

#include <Eigen/Core>

#include <optional>
#include <string>
#include <vector>

namespace suture::algebraic {

/// A hole in unit coordinates.
struct Problem {
    /// Of polynomial neighbours, or (k <= 2) of any: one of the two is given.
    std::vector<Side<double>> sides;
    std::vector<SideJets> jets;
    /// How far a member may miss the jets: distance in unit coordinates, angle.
    Tolerance at_sides;
    std::vector<UnitCurve> curves;
    View view;
    std::vector<GuidePoint> guide;
    int interface_k = 1;  ///< how smoothly the cells meet
};

/// What to try; by default degrees from the lowest possible up, each on both partitions.
struct Search {
    std::optional<int> degree;
    std::optional<bool> inner_cells;
    double rank_tolerance = 1e-9;
};

/// A piecewise algebraic surface, and how it was found.
struct Solution {
    Partition partition;
    std::vector<Eigen::Vector3d> rays;      ///< from the centre; see Partition
    std::vector<Polynomial<double>> cells;  ///< one for each cell
    int degree = 0;
    int rows = 0, columns = 0, rank = 0, dimension = 0;
    int polynomials = 0;      ///< dimension of the space of g
    bool guided_only = true;  ///< false where the conditions for a single sheet had to be imposed
    bool proven = true;       ///< false where the single sheet was only seen on sampled rays
    double seen = 0.0;        ///< how far along the rays from the guide, unless proven
    double slope = 0.0;       ///< proven: dg along the unit ray is at least this near the surface
    double deviation = 0.0;   ///< root mean square of distance and angle to the guide
    double side_distance = 0.0;      ///< largest |g| / |grad g| at the jets, in unit coordinates
    double side_angle = 0.0;         ///< largest angle between grad g and the jets' normals
    std::vector<std::string> tried;  ///< what was not taken, and why
};

/// The certified frusta of a sector, around the guide's points in it.
struct Band {
    int sector = 0;
    Frustum frustum;
    double middle = 0.5;  ///< where the guide runs, from t0 = 0 to t1 = 1
};

/// The barycentric coordinates with respect to a sector's rays of the ray through a point, and how
/// far along it the point is: point = centre + t sum b_j d_j.
struct OnRay {
    Eigen::Vector3d b;
    double t = 0.0;
};
[[nodiscard]] OnRay on_ray(const Eigen::Matrix3d& directions, const Eigen::Vector3d& from_centre);
[[nodiscard]] Eigen::Matrix3d directions_of(const Sector& sector,
                                            const std::vector<Eigen::Vector3d>& rays);

/// The first degree and partition that has a member with one proven sheet near the guide: the
/// degree is raised and the partition refined until there is one.
///
/// Refuses  corners in which no regular surface has the neighbours' curvatures; where no member up
/// to
///          the highest degree has one sheet, with what was tried.
/// Source   Chen, Chen, Deng, Feng 2000, section 3; the choice inside the solutions is our own.
[[nodiscard]] Result<Solution> find_solution(const Problem& problem, const Search& search,
                                             const Progress& progress);

}  // namespace suture::algebraic

#pragma once

#include "suture/base/progress.h"
#include "suture/base/result.h"
#include "suture/check/profile.h"

#include <Eigen/Core>

#include <TopoDS_Shape.hxx>

#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace suture {

/// What an edge between two faces is. G0 is also what could not be measured.
enum class EdgeClass { Sharp, G0, G1, G2, G3 };

[[nodiscard]] std::string_view to_string(EdgeClass edge_class);

/// Measured along one edge shared by two faces (or by one face with itself: a seam).
///
/// At a point of the edge's curve, P1 and P2 are the nearest points of the two faces' surfaces.
/// Positions are points of the edge where the largest value was found. Angles in radians between
/// the outward normals at P1 and P2; curvatures are normal curvatures perpendicular to the edge,
/// positive where the face bends towards its outward normal. Exact definitions: docs/check.md.
struct EdgeContinuity {
    int edge = 0;                       ///< EdgeN, 1-based
    std::array<int, 2> faces = {0, 0};  ///< FaceN, 1-based; equal for a seam
    EdgeClass edge_class = EdgeClass::Sharp;
    double length = 0.0;
    double max_gap = 0.0;   ///< distance between the two faces at the edge: |P1 - P2|
    double edge_gap = 0.0;  ///< largest distance of the edge's curve from P1 or P2
    double max_angle = 0.0;
    double mean_angle = 0.0;
    double min_angle = 0.0;
    double curvature_mismatch = 0.0;      ///< max |k1-k2| / max(|k1|,|k2|)
    double curvature_mismatch_sum = 0.0;  ///< max |R1-R2| / (R1+R2) = |k1-k2| / (|k1|+|k2|)
    double curvature_difference = 0.0;    ///< max |k1-k2|, per unit of length
    bool opposite_concavity = false;      ///< k1 and k2 of different sign somewhere
    double g3_mismatch = 0.0;             ///< radians; only if g3_samples > 0
    Eigen::Vector3d gap_at = Eigen::Vector3d::Zero();
    Eigen::Vector3d angle_at = Eigen::Vector3d::Zero();
    Eigen::Vector3d curvature_at = Eigen::Vector3d::Zero();
    Eigen::Vector3d g3_at = Eigen::Vector3d::Zero();
    /// Where these points lie along the edge: parts of its length, 0 to 1, in its own direction.
    double gap_along = 0.0, angle_along = 0.0, curvature_along = 0.0;
    int samples = 0;            ///< points at which gap and angle could be measured
    int curvature_samples = 0;  ///< points at which the curvatures could be compared
    int g3_samples = 0;  ///< points at which their changes could be; 0 where it means nothing
    std::string note;    ///< what could not be measured, what looks odd, else empty
};

struct ContinuityReport {
    std::vector<EdgeContinuity> edges;  ///< every edge between two faces, by edge number
    std::vector<int> free_edges;        ///< edges used by one face only, no seams
    std::vector<int> non_manifold;      ///< edges used by more than two faces
};

/// The class of an edge from its figures.
[[nodiscard]] EdgeClass classify(const EdgeContinuity& edge, const Profile& profile);

/// Measures every edge of a shape, or only the given ones (1-based EdgeN; empty: all).
///
/// Dense samples with local refinement at the maxima, end points included. Shares no code with the
/// fill methods or the ribbons. Deterministic; runs on all cores.
/// Result   free_edges and non_manifold are among the given edges too.
/// Refuses  a null shape, an edge that does not exist, thresholds that are not positive (Usage); a
///          cancelled run. An edge that cannot be measured is no error: its note says why.
[[nodiscard]] Result<ContinuityReport> measure_continuity(const TopoDS_Shape& shape,
                                                          const Profile& profile,
                                                          const std::vector<int>& edges,
                                                          const Progress& progress);

}  // namespace suture

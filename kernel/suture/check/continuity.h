#pragma once

#include <TopoDS_Shape.hxx>

#include <Eigen/Core>
#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "suture/base/progress.h"
#include "suture/base/result.h"
#include "suture/base/tolerance.h"

namespace suture {

/// What an edge between two faces is.
enum class EdgeClass { Sharp, G0, G1, G2 };

[[nodiscard]] std::string_view to_string(EdgeClass edge_class);

/// Thresholds of a continuity check, and what they are called.
struct Profile {
    std::string name = "catia";
    Tolerance tolerance;             ///< G0, G1, G2 thresholds
    double sharp = radians(5.0);     ///< above: a design edge, not a failed smooth one
};

/// Measured along one edge shared by two faces (or by one face with itself: a seam).
///
/// Positions are where the largest value was found. Angles in radians between outward normals;
/// curvatures are normal curvatures perpendicular to the edge.
struct EdgeContinuity {
    int edge = 0;                       ///< EdgeN, 1-based
    std::array<int, 2> faces = {0, 0};  ///< FaceN, 1-based; equal for a seam
    EdgeClass edge_class = EdgeClass::Sharp;
    double length = 0.0;
    double max_gap = 0.0;               ///< distance between the two faces at the edge
    double max_angle = 0.0;
    double mean_angle = 0.0;
    double curvature_mismatch = 0.0;    ///< max |k1-k2| / max(|k1|,|k2|)
    double curvature_mismatch_sum = 0.0;///< max |R1-R2| / (R1+R2) = |k1-k2| / (|k1|+|k2|)
    bool opposite_concavity = false;    ///< k1 and k2 of different sign somewhere
    Eigen::Vector3d gap_at = Eigen::Vector3d::Zero();
    Eigen::Vector3d angle_at = Eigen::Vector3d::Zero();
    Eigen::Vector3d curvature_at = Eigen::Vector3d::Zero();
    std::string note;                   ///< why something could not be measured, else empty
};

struct ContinuityReport {
    std::vector<EdgeContinuity> edges;  ///< every edge between two faces, by edge number
    std::vector<int> free_edges;        ///< edges used by one face only, no seams
    std::vector<int> non_manifold;      ///< edges used by more than two faces
};

/// Measures every edge of a shape, or only the given ones (1-based EdgeN; empty: all).
///
/// Dense samples with local refinement at the maxima, end points included. Shares no code with the
/// fill methods or the ribbons. Deterministic; runs on all cores.
[[nodiscard]] Result<ContinuityReport> measure_continuity(const TopoDS_Shape& shape,
                                                          const Profile& profile,
                                                          const std::vector<int>& edges,
                                                          const Progress& progress);

}  // namespace suture

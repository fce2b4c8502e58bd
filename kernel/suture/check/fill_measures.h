#pragma once

#include "suture/base/progress.h"
#include "suture/base/result.h"
#include "suture/base/through_point.h"
#include "suture/base/tolerance.h"
#include "suture/check/area_ratio.h"
#include "suture/check/clashes.h"
#include "suture/check/continuity.h"
#include "suture/check/face_knots.h"
#include "suture/check/folds.h"
#include "suture/occ/topology.h"

#include <Eigen/Core>

#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>

#include <vector>

namespace suture {

/// Where a fill is in a shape, by the shape's own numbers.
struct FillPlace {
    std::vector<int> sides;  ///< EdgeN of each side of the hole, in their order; 0: not found
    std::vector<int> faces;  ///< FaceN of the new faces; 0: not found
    /// The face, in the shape's coordinates, against which angle and curvature of a side count;
    /// null: the neighbour. As `sides`, or empty.
    std::vector<TopoDS_Face> supports;
    std::vector<ThroughPoint> through;  ///< points that the new faces were to pass
};

/// An edge of a new face, and what it is good for in the shape.
struct EdgeFacts {
    int edge = 0;  ///< EdgeN
    double tolerance = 0.0;
    Eigen::Vector3d at = Eigen::Vector3d::Zero();  ///< the middle of the edge
};

/// What a fill is like in a shape. All edges and faces by the shape's own numbers.
struct FillMeasures {
    std::vector<EdgeContinuity> sides;  ///< as FillPlace::sides; no samples: not measured
    std::vector<EdgeContinuity> inner;  ///< edges of new faces that are no sides
    std::vector<KnotLine> creases;      ///< knot lines of the new faces
    std::vector<FaceFold> folds;        ///< one for each new face that was found
    AreaRatio area;                     ///< of the new faces that were found
    std::vector<Clash> clashes;         ///< by measure_clashes alone, as the next
    std::vector<Overlay> overlays;
    std::vector<EdgeFacts> edges;          ///< all edges of the new faces
    std::vector<EdgeFacts> open_edges;     ///< of these and the sides: those that one face uses
    std::vector<EdgeFacts> crowded_edges;  ///< the same that more than two faces use
    int lost_faces = 0;                    ///< new faces that were not found
    double through = 0.0;                  ///< largest distance of a point that was to be passed
    Eigen::Vector3d through_at = Eigen::Vector3d::Zero();
    double through_angle = 0.0;  ///< largest angle between a normal wanted there and the face's
    Eigen::Vector3d through_angle_at = Eigen::Vector3d::Zero();
};

/// Measures fills in a shape that holds them, all in one run of the continuity check: everything
/// but the clashes.
///
/// Input    numbering: the shape's.
/// Refuses  what measure_continuity refuses.
[[nodiscard]] Result<std::vector<FillMeasures>> measure_fills(const TopoDS_Shape& shape,
                                                              const occ::Numbering& numbering,
                                                              const std::vector<FillPlace>& places,
                                                              const Profile& profile,
                                                              const Progress& progress);

/// Looks where a fill passes through other faces of the shape or lies on them.
///
/// Input    diameter: of the hole.
/// Changes  measures: clashes and overlays.
[[nodiscard]] Result<void> measure_clashes(const TopoDS_Shape& shape, const FillPlace& place,
                                           double diameter, const Tolerance& tolerance,
                                           const Progress& progress, FillMeasures& measures);

}  // namespace suture

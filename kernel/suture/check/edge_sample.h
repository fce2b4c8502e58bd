#pragma once

#include "suture/check/face_side.h"

#include <BRepAdaptor_Curve.hxx>
#include <gp_Pnt.hxx>

#include <array>
#include <vector>

namespace suture {

/// What is measured at one point of an edge. What could not be measured is below every value.
struct EdgeSample {
    double t = 0.0;
    gp_Pnt point;
    double speed = 0.0;
    double gap = -1.0, edge_gap = -1.0, angle = -1.0, mismatch = -1.0, mismatch_sum = -1.0;
    double difference = 0.0;  ///< |k1 - k2|
    double g3 = -1.0;
    double excess = 0.0;  ///< of the first face's curvature over the second's, both unsigned
    bool opposite = false;
    bool failed = false;
};

/// Sets the mismatches of two curvatures across an edge of this length.
void compare_curvatures(double k1, double k2, double length, EdgeSample& sample);

/// Sets the G3 mismatch, of border points with curvatures and their slopes, where it means
/// something.
void compare_slopes(const BorderPoint& one, const BorderPoint& two, double length,
                    EdgeSample& sample);

/// Where an edge is to be sampled: both ends, and points between them.
[[nodiscard]] std::vector<double> sample_parameters(const BRepAdaptor_Curve& curve,
                                                    const EdgeRange& range,
                                                    const std::array<FaceSide, 2>& sides);

}  // namespace suture

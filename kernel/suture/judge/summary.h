#pragma once

#include "suture/check/continuity.h"
#include "suture/check/face_knots.h"

#include <string>
#include <vector>

namespace suture {

/// Neither sharp nor within the limits: the faces do not meet within the gap, or they meet at an
/// angle between tangent and sharp. An edge that could not be measured is no near miss.
[[nodiscard]] bool is_near_miss(const EdgeContinuity& edge, const Profile& profile);
[[nodiscard]] bool is_near_miss(const KnotLine& line, const Profile& profile);

/// By how many times the edge exceeds the limits of gap and angle; the angle of a sharp edge is
/// meant to be, and counts nothing.
[[nodiscard]] double severity(const EdgeContinuity& edge, const Profile& profile);

/// Unmeasured edges and near misses first, then what is smooth, sharp edges last; the worst on top.
[[nodiscard]] std::vector<EdgeContinuity> worst_first(std::vector<EdgeContinuity> edges,
                                                      const Profile& profile);

/// "gap 0.02 mm > 0.001 mm; angle 1.5 deg between 0.01 and 5": why an edge is a near miss.
[[nodiscard]] std::string fault_of(const EdgeContinuity& edge, const Profile& profile);

/// A whole model in a few numbers.
struct CheckSummary {
    int edges = 0, sharp = 0, g0 = 0, g1 = 0, g2 = 0, g3 = 0;
    int near_misses = 0, unmeasured = 0;
    int knot_lines = 0, knot_near_misses = 0;  ///< inside faces
    double max_gap = 0.0, max_angle = 0.0;     ///< of the edges that are not sharp

    [[nodiscard]] bool pass() const { return near_misses + unmeasured + knot_near_misses == 0; }
};

[[nodiscard]] CheckSummary summarise(const ContinuityReport& report,
                                     const std::vector<KnotLine>& knots, const Profile& profile);

}  // namespace suture

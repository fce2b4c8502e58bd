#pragma once

#include "suture/base/through_point.h"
#include "suture/judge/judge_fill.h"
#include "suture/model/continuity.h"
#include "suture/model/recognised.h"

#include <Eigen/Core>

#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace suture {

enum class FillStatus { Filled, Refused, Skipped };

[[nodiscard]] std::string_view to_string(FillStatus status);

/// One surface of a fill, for the report.
struct PatchFacts {
    std::string kind;  ///< kind_name of the surface
    int degree_u = 0, degree_v = 0, poles_u = 0,
        poles_v = 0;  ///< as a B-spline; 0 for closed forms
    bool rational = false;
    bool exact = true;
    double fit_error = 0.0;
    int face = 0;  ///< FaceN in the result
};

/// How one side of a fill came out.
struct SideReport {
    int edge = 0;         ///< EdgeN in the input; 0: a curve that was made
    int face = 0;         ///< the neighbour, FaceN in the input; 0: there is none
    TopoDS_Face support;  ///< what it was to be tangent to instead of a neighbour; or null
    TopoDS_Edge on_edge;  ///< the edge itself, in the part's own coordinates
    Continuity requested = Continuity::G1;
    std::string reason;  ///< why auto asked for just that
    double gap = 0.0, angle = 0.0, curvature_mismatch = 0.0;
};

/// What became of one hole. Lengths in model units, angles in radians.
struct HoleReport {
    std::vector<int> ids;  ///< loop ids
    FillStatus status = FillStatus::Skipped;
    std::string method_requested, method_used;
    Continuity continuity_requested = Continuity::G1;
    Continuity continuity_reached = Continuity::G0;
    double max_gap = 0.0, max_angle = 0.0, max_curvature_mismatch = 0.0;
    std::vector<PatchFacts> patches;
    std::vector<SideReport> sides;
    std::optional<Recognised> recognised;  ///< in the part's own coordinates
    std::vector<ThroughPoint> through;     ///< points that were to be passed
    double max_distance_through = 0.0;     ///< of these points from the new face
    double max_angle_through = 0.0;        ///< between the normals wanted there and the face's own
    std::vector<std::string> notes;
    double seconds = 0.0;
    std::string reason;  ///< why this method, or why refused or skipped
    bool tried = false;  ///< the figures are those of a fill: of the best try where it was refused
    AskedFill asked;     ///< what the figures are held against
    /// As found when it was computed, with all of the shape around; without face numbers.
    std::vector<Clash> clashes;
    std::vector<Overlay> overlays;
    Judgement verdict;  ///< what they are worth
};

/// Sets the figures of a hole, and what they are worth. Used for what was tried, and for what was
/// read back.
///
/// Changes  report: its sides, maxima, continuity reached and verdict.
void set_figures(const FillMeasures& measures, HoleReport& report);

}  // namespace suture

#pragma once

#include <TopoDS_Shape.hxx>

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "suture/base/progress.h"
#include "suture/base/result.h"
#include "suture/base/tolerance.h"
#include "suture/detect/find_loops.h"
#include "suture/model/continuity.h"
#include "suture/occt_filling/plate.h"

namespace suture {

/// What the user asks for.
struct FillRequest {
    std::vector<std::vector<int>> holes;  ///< loop ids; several in one entry: one face with islands
    std::vector<int> edges;               ///< EdgeN: the loops that contain them
    bool all_loops = false;               ///< rims and ambiguous loops too
    std::string method = "auto";
    std::optional<Continuity> continuity;             ///< none: auto
    std::map<int, Continuity> edge_continuity;        ///< EdgeN -> continuity
    PlateSetting plate_setting = PlateSetting::Default;
    Tolerance tolerance;
    int jobs = 0;                                     ///< threads; 0: all cores
    Progress progress;
};

enum class FillStatus { Filled, Refused, Skipped };

[[nodiscard]] std::string_view to_string(FillStatus status);

/// One surface of a fill, for the report.
struct PatchFacts {
    std::string kind;  ///< kind_name of the surface
    int degree_u = 0, degree_v = 0, poles_u = 0, poles_v = 0;  ///< as a B-spline; 0 for closed forms
    bool rational = false;
    bool exact = true;
    double fit_error = 0.0;
    int face = 0;      ///< FaceN in the result
};

/// How one side of a fill came out.
struct SideReport {
    int edge = 0;                        ///< EdgeN in the input
    int face = 0;                        ///< the neighbour, FaceN in the input
    Continuity requested = Continuity::G1;
    std::string reason;                  ///< why auto asked for just that
    double gap = 0.0, angle = 0.0, curvature_mismatch = 0.0;
};

/// What became of one hole. Lengths in model units, angles in radians.
struct HoleReport {
    std::vector<int> ids;     ///< loop ids
    FillStatus status = FillStatus::Skipped;
    std::string method_requested, method_used;
    Continuity continuity_requested = Continuity::G1;
    Continuity continuity_reached = Continuity::G0;
    double max_gap = 0.0, max_angle = 0.0, max_curvature_mismatch = 0.0;
    std::vector<PatchFacts> patches;
    std::vector<SideReport> sides;
    std::vector<std::string> notes;
    double seconds = 0.0;
    std::string reason;       ///< why this method, or why refused or skipped
    bool within_tolerance = false;
};

struct FillOutcome {
    TopoDS_Shape shape;
    std::vector<HoleReport> holes;
    std::vector<TopoDS_Face> new_faces;
    double seconds_fill = 0.0;   ///< in the fill methods themselves
    double seconds_sew = 0.0;
};

/// The whole flow from a shape to a shape: find holes, ribbons, fill, faces, join, check.
///
/// Input    shape with loose faces already sewn; numbering of the model that it is part of.
/// Refuses  unknown methods, hole ids and edges that do not exist (Usage); a shape without a hole
///          (NothingToDo). A hole that cannot be filled is no error: its report says why.
[[nodiscard]] Result<FillOutcome> fill_holes(const TopoDS_Shape& shape,
                                             const occ::Numbering& numbering,
                                             const FillRequest& request);

}  // namespace suture

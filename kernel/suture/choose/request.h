#pragma once

#include "suture/base/progress.h"
#include "suture/base/through_point.h"
#include "suture/base/tolerance.h"
#include "suture/candidates/model_candidates.h"
#include "suture/fill/fill.h"
#include "suture/model/continuity.h"
#include "suture/occt_filling/plate.h"

#include <Eigen/Core>

#include <chrono>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace suture {

/// How much `auto` tries where nothing is within tolerance at once.
enum class Effort {
    Quick,    ///< what takes least time
    Normal,   ///< methods that come nearer as well, where a fill is near
    Thorough  ///< all that can come nearer
};

/// What the user asks for.
struct FillRequest {
    std::vector<std::vector<int>> holes;  ///< loop ids; several in one entry: one face with islands
    std::vector<int> edges;               ///< EdgeN: the loops that contain them
    /// EdgeN: each entry bounds one new face, with or without neighbours; instead of holes and
    /// edges
    std::vector<std::vector<int>> boundaries;
    int first_new_id = 1;         ///< ids of what is filled and is no loop of the shape
    bool bridge = false;          ///< each boundary has to be two chains or two closed rims
    bool connect = false;         ///< bridge gaps in them by curves
    std::map<int, int> supports;  ///< EdgeN -> FaceN to be tangent to there
    double tension = 1.0;  ///< how far these go on straight from both ends, 1: as the gap is wide
    double reach = 0.0;    ///< gaps in them up to this close by themselves
    /// Holes are cut in two, one face for each part: along a line between two corners, which lie
    /// at these points; or, split_sharp, between sharp turns where that helps.
    std::vector<std::pair<Eigen::Vector3d, Eigen::Vector3d>> splits;
    bool split_sharp = false;
    bool all_loops = false;  ///< rims and ambiguous loops too
    std::string method = "auto";
    OptionValues options;                       ///< the method's own
    std::optional<Continuity> continuity;       ///< none: auto
    std::map<int, Continuity> edge_continuity;  ///< EdgeN -> continuity
    std::vector<ThroughPoint> through;          ///< what the one new face has to pass
    Effort effort = Effort::Normal;             ///< of `auto`
    PlateSetting plate_setting = PlateSetting::Default;
    Tolerance tolerance;
    std::chrono::milliseconds plate_limit{120'000};  ///< for each run of OCCT's filling
    bool keep_bad = false;        ///< put fills into the model that the judge calls bad
    std::vector<int> leave_open;  ///< ids of holes whose fills came out bad in the written file
    /// Hole -> names of the fills that came out worse in the file: the next one is asked for.
    std::map<int, std::vector<std::string>> spoilt;
    /// Where the lost face's surface is looked for; none: `auto` leaves `recognise` out.
    std::optional<Scope> recognise = Scope::Model;
    Prefer prefer = Prefer::Tight;
    Progress progress;
};

}  // namespace suture

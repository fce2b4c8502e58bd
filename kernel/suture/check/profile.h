#pragma once

#include "suture/base/result.h"
#include "suture/base/tolerance.h"

#include <string>
#include <string_view>
#include <vector>

namespace suture {

/// By what the difference of two curvatures is divided.
enum class CurvatureMeasure {
    Larger,  ///< |k1-k2| / max(|k1|,|k2|)
    Sum      ///< |k1-k2| / (|k1|+|k2|) = |R1-R2| / (R1+R2)
};

[[nodiscard]] std::string_view to_string(CurvatureMeasure measure);

/// Thresholds of a continuity check, and what they are called.
struct Profile {
    std::string name = "catia";
    Tolerance tolerance;  ///< G0, G1, G2 thresholds
    CurvatureMeasure curvature_by = CurvatureMeasure::Larger;
    double g3 = radians(0.1);     ///< largest G3 mismatch, in radians (docs/check.md)
    double sharp = radians(5.0);  ///< above: a design edge, not a failed smooth one
    std::string source = "CATIA Connect Checker, newer documentation";
};

/// The named profiles, the default first.
///
/// Source   catia: CATIA Connect Checker (0.001 mm, 0.01 deg, 2 %, 0.1 deg); vda4955: Creo
///          ModelCHECK after VDA 4955 (0.020 mm, 0.1 deg, 10 %); alias: the angle below which Alias
///          calls a break invisible, and its definition of curvature deviation; rhino: the
///          tolerances of a new Rhino document (0.001, 1 deg, 1 %), its definition of curvature;
///          occt: OCCT's LocalAnalysis (0.001, 0.001 rad, 1 %). What a checker does not publish is
///          taken over from catia, as is said in `source`; the limit of a sharp edge is our own.
[[nodiscard]] const std::vector<Profile>& profiles();

/// Refuses  (Usage) a name that is none of profiles(); the message lists them.
[[nodiscard]] Result<Profile> find_profile(std::string_view name);

/// Refuses  (Usage) thresholds that are not positive finite numbers.
[[nodiscard]] Result<void> validate(const Profile& profile);

}  // namespace suture

#pragma once

#include "suture/base/result.h"
#include "suture/base/tolerance.h"

#include <string>
#include <string_view>
#include <vector>

namespace suture {

/// Thresholds of a continuity check, and what they are called.
struct Profile {
    std::string name = "catia";
    Tolerance tolerance;          ///< G0, G1, G2 thresholds
    double sharp = radians(5.0);  ///< above: a design edge, not a failed smooth one
    std::string source = "CATIA Connect Checker, newer documentation";
};

/// The named profiles, the default first.
///
/// Source   catia: CATIA Connect Checker (0.001 mm, 0.01 deg, 2 %); vda4955: Creo ModelCHECK after
///          VDA 4955 (0.020 mm, 0.1 deg, 10 %); occt: OCCT's LocalAnalysis (0.001, 0.001 rad, 1 %).
///          Checkers that publish no full set of figures (Alias, Rhino) have no profile here. The
///          limit of a sharp edge is our own.
[[nodiscard]] const std::vector<Profile>& profiles();

/// Refuses  (Usage) a name that is none of profiles(); the message lists them.
[[nodiscard]] Result<Profile> find_profile(std::string_view name);

}  // namespace suture

#include "suture/check/profile.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

namespace suture {

std::string_view to_string(CurvatureMeasure measure) {
    return measure == CurvatureMeasure::Larger ? "larger" : "sum";
}

const std::vector<Profile>& profiles() {
    static const std::vector<Profile> list = {
        Profile{},
        Profile{.name = "vda4955",
                .tolerance = {.linear = 0.02, .angular = radians(0.1), .curvature = 0.10},
                .source = "Creo ModelCHECK, VDA 4955 / SASIG; G3 as catia"},
        Profile{.name = "alias",
                .tolerance = {.linear = 1e-3, .angular = radians(0.1), .curvature = 0.10},
                .curvature_by = CurvatureMeasure::Sum,
                .source = "Alias Theory Builders: a tangent break below 0.1 deg is not visible, "
                          "curvature as (R1-R2)/(R1+R2); gap and G3 as catia, 10 % as vda4955"},
        Profile{.name = "rhino",
                .tolerance = {.linear = 1e-3, .angular = radians(1.0), .curvature = 0.01},
                .curvature_by = CurvatureMeasure::Sum,
                .source = "Rhino, tolerances of a new document: absolute 0.001, angle 1 deg, "
                          "relative 1 %; curvature as EdgeContinuity; G3 as catia"},
        Profile{.name = "occt",
                .tolerance = {.linear = 1e-3, .angular = 1e-3, .curvature = 0.01},
                .source = "OCCT LocalAnalysis, default arguments; G3 as catia"},
    };
    return list;
}

Result<Profile> find_profile(std::string_view name) {
    const auto& list = profiles();
    const auto found = std::ranges::find(list, name, &Profile::name);
    if (found != list.end()) {
        return *found;
    }
    std::vector<std::string> names;
    std::ranges::transform(list, std::back_inserter(names), &Profile::name);
    return fail(ErrorCode::Usage, "no profile is called \"{}\"; there are: {}", name,
                fmt::join(names, ", "));
}

Result<void> validate(const Profile& profile) {
    for (const auto& [what, value] :
         {std::pair("angle of a sharp edge", profile.sharp), std::pair("G3 limit", profile.g3)}) {
        if (!(value > 0.0) || !std::isfinite(value)) {
            return fail(ErrorCode::Usage, "the {} must be positive, not {} rad", what, value);
        }
    }
    return validate(profile.tolerance);
}

}  // namespace suture

#include "suture/check/profile.h"

#include <fmt/ranges.h>

#include <algorithm>

namespace suture {

const std::vector<Profile>& profiles() {
    static const std::vector<Profile> list = {
        Profile{},
        Profile{.name = "vda4955",
                .tolerance = {.linear = 0.02, .angular = radians(0.1), .curvature = 0.10},
                .source = "Creo ModelCHECK, VDA 4955 / SASIG"},
        Profile{.name = "occt",
                .tolerance = {.linear = 1e-3, .angular = 1e-3, .curvature = 0.01},
                .source = "OCCT LocalAnalysis, default arguments"},
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

}  // namespace suture

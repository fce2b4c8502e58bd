#include "report/profile_json.h"

namespace suture::report {

nlohmann::ordered_json json_of(const Profile& profile) {
    return {{"name", profile.name},
            {"source", profile.source},
            {"g0_mm", profile.tolerance.linear},
            {"g1_deg", degrees(profile.tolerance.angular)},
            {"g2_percent", 100.0 * profile.tolerance.curvature},
            {"g2_by", to_string(profile.curvature_by)},
            {"g3_deg", degrees(profile.g3)},
            {"sharp_deg", degrees(profile.sharp)}};
}

}  // namespace suture::report

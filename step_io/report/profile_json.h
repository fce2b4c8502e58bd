#pragma once

#include "suture/check/profile.h"

#include <nlohmann/json.hpp>

namespace suture::report {

/// A profile's limits as all our JSON has them: lengths in mm, angles in degrees.
[[nodiscard]] nlohmann::ordered_json json_of(const Profile& profile);

}  // namespace suture::report

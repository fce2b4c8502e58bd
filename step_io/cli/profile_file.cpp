#include "cli/profile_file.h"

#include "cli/json_file.h"

#include <functional>
#include <map>

namespace suture::cli {
namespace {

using json = nlohmann::ordered_json;

/// Sets what a key stands for; false if the value is of the wrong kind.
using Setter = std::function<bool(const json&)>;

Setter number(double& target, double factor) {
    return [&target, factor](const json& value) {
        if (!value.is_number()) {
            return false;
        }
        target = factor * value.get<double>();
        return true;
    };
}

Setter text(std::string& target) {
    return [&target](const json& value) {
        if (!value.is_string()) {
            return false;
        }
        target = value.get<std::string>();
        return true;
    };
}

Setter measure(CurvatureMeasure& target) {
    return [&target](const json& value) {
        for (const auto option : {CurvatureMeasure::Larger, CurvatureMeasure::Sum}) {
            if (value.is_string() && value.get<std::string>() == to_string(option)) {
                target = option;
                return true;
            }
        }
        return false;
    };
}

}  // namespace

Result<Profile> read_profile(const std::filesystem::path& file) {
    const auto refuse = [&](std::string_view why) {
        return fail(ErrorCode::Usage, "--profile {}: {}", file.string(), why);
    };
    const Result<json> read = read_json(file);
    if (!read) {
        return fail(ErrorCode::Usage, "--profile: {}", read.error().message);
    }
    const json& document = *read;
    if (!document.is_object()) {
        return refuse("it is no JSON object");
    }
    constexpr double kDegree = kPi / 180.0;
    Profile profile;
    profile.name = "custom";
    profile.source = file.filename().string();
    const std::map<std::string, Setter> setters = {
        {"name", text(profile.name)},
        {"source", text(profile.source)},
        {"g0_mm", number(profile.tolerance.linear, 1.0)},
        {"g1_deg", number(profile.tolerance.angular, kDegree)},
        {"g2_percent", number(profile.tolerance.curvature, 0.01)},
        {"g2_by", measure(profile.curvature_by)},
        {"g3_deg", number(profile.g3, kDegree)},
        {"sharp_deg", number(profile.sharp, kDegree)}};
    for (const auto& [key, value] : document.items()) {
        const auto setter = setters.find(key);
        if (setter == setters.end()) {
            return refuse("it has the unknown key \"" + key + '"');
        }
        if (!setter->second(value)) {
            return refuse("the value of \"" + key + "\" is of the wrong kind");
        }
    }
    for (const char* key : {"g0_mm", "g1_deg", "g2_percent"}) {
        if (!document.contains(key)) {
            return refuse(std::string("it lacks ") + key);
        }
    }
    if (const auto valid = validate(profile); !valid) {
        return refuse(valid.error().message);
    }
    return profile;
}

}  // namespace suture::cli

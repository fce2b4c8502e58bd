#include "suture/fill/recognise/describe.h"

#include "suture/base/tolerance.h"
#include "suture/fill/recognise/form.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace suture::recognise {
namespace {

struct Letters {
    const Surface& form;

    [[nodiscard]] std::vector<std::pair<std::string, double>> sizes() const {
        if (const auto* sphere = std::get_if<Sphere>(&form)) {
            return {{"radius", sphere->radius}};
        }
        if (const auto* cylinder = std::get_if<Cylinder>(&form)) {
            return {{"radius", cylinder->radius}};
        }
        if (const auto* cone = std::get_if<Cone>(&form)) {
            return {{"half angle", degrees(cone->half_angle)}, {"radius", cone->radius}};
        }
        if (const auto* torus = std::get_if<Torus>(&form)) {
            return {{"major radius", torus->major}, {"minor radius", torus->minor}};
        }
        return {};
    }
};

/// How a parameter is called in a sentence.
std::string letter(const std::string& name) {
    if (name == "major radius") {
        return "R";
    }
    return name == "half angle" ? "half angle" : "r";
}

}  // namespace

Recognised describe(const Surface& form, const Agreement& agreement, const Border& border) {
    Recognised result;
    result.kind = kind_name(form);
    result.parameters = Letters{form}.sizes();
    result.gap = agreement.gap * border.size;
    result.angle = agreement.angle;
    if (closed_form(form)) {
        result.point = frame_of(form).origin;
        if (!std::holds_alternative<Sphere>(form)) {
            result.axis = frame_of(form).z;
        }
    }
    result.from = "the hole's border and its neighbours' normals";
    return result;
}

Recognised describe_ball(double radius, std::size_t sides, const Agreement& agreement,
                         const Border& border) {
    Recognised result;
    result.kind = "rolling ball";
    result.parameters = {{"radius", radius}};
    result.gap = agreement.gap * border.size;
    result.angle = agreement.angle;
    result.from = sides == 2
                      ? "a ball that touches two neighbours all along"
                      : fmt::format("a ball that touches {} neighbours, a pair at a time", sides);
    return result;
}

std::string sentence(const Recognised& recognised, const Agreement& agreement,
                     const std::vector<std::string>& facts) {
    std::string text = recognised.kind;
    const char* separator = " ";
    for (const auto& [name, value] : recognised.parameters) {
        const bool angle = name == "half angle";
        text += fmt::format("{}{} = {:.7g}{}", separator, letter(name), value, angle ? " deg" : "");
        separator = ", ";
    }
    std::vector<int> faces = agreement.faces;
    std::sort(faces.begin(), faces.end());
    faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
    if (!faces.empty()) {
        text += fmt::format(", tangent to face{} {}", faces.size() == 1 ? "" : "s",
                            fmt::join(faces, ", "));
    }
    for (const std::string& fact : facts) {
        text += "; " + fact;
    }
    return text;
}

}  // namespace suture::recognise

#include "suture/judge/finding.h"

#include "suture/base/tolerance.h"

#include <fmt/format.h>

#include <array>
#include <cstddef>
#include <tuple>

namespace suture {
namespace {

enum class Unit { Length, Angle, Share, Ratio, None };

/// How each kind is named and told, in the order of FindingKind.
struct KindRow {
    std::string_view id;
    std::string_view words;
    Unit unit;
};

constexpr std::array<KindRow, 16> kKinds{{
    {"gap", "gap", Unit::Length},
    {"angle", "angle", Unit::Angle},
    {"curvature", "curvature mismatch", Unit::Share},
    {"crease", "crease inside the new face of", Unit::Angle},
    {"fold", "the new face folds", Unit::None},
    {"clash", "the new face cuts another one, to a depth of", Unit::Length},
    {"lies_on_face", "the new face lies on another one, with a share of", Unit::Share},
    {"balloon", "area over that of a surface stretched across the hole:", Unit::Ratio},
    {"tolerance_grown", "the edge's tolerance grew to", Unit::Length},
    {"tangency_given_up", "tangency given up, angle", Unit::Angle},
    {"through", "distance of a point to be passed", Unit::Length},
    {"through_angle", "angle to the normal wanted at a point,", Unit::Angle},
    {"open_edge", "an edge of the new face does not belong to two faces", Unit::None},
    {"not_measured", "could not be measured", Unit::None},
    {"not_valid", "the shape is not valid", Unit::None},
    {"changed_by_writing", "worse in the written file than in memory, by a factor of", Unit::Ratio},
}};

const KindRow& row_of(FindingKind kind) {
    return kKinds.at(static_cast<std::size_t>(kind));
}

std::string figure(double value, FindingKind kind) {
    const std::string_view unit = unit_of(kind);
    return fmt::format("{:.4g}{}{}", in_unit(value, kind), unit.empty() ? "" : " ", unit);
}

}  // namespace

std::string_view to_string(Severity severity) {
    constexpr std::array<std::string_view, 4> kNames{"good", "near", "poor", "bad"};
    return kNames.at(static_cast<std::size_t>(severity));
}

std::string_view to_string(FindingKind kind) {
    return row_of(kind).id;
}

std::string_view unit_of(FindingKind kind) {
    switch (row_of(kind).unit) {
        case Unit::Length:
            return "mm";
        case Unit::Angle:
            return "deg";
        case Unit::Share:
            return "%";
        case Unit::Ratio:
        case Unit::None:
            break;
    }
    return {};
}

double in_unit(double value, FindingKind kind) {
    switch (row_of(kind).unit) {
        case Unit::Angle:
            return degrees(value);
        case Unit::Share:
            return 100.0 * value;
        case Unit::Length:
        case Unit::Ratio:
        case Unit::None:
            break;
    }
    return value;
}

double excess(const Finding& finding) {
    return finding.limit > 0.0 ? finding.value / finding.limit : 1.0 + finding.value;
}

bool is_worse(const Finding& a, const Finding& b) {
    return std::tuple(a.severity, !a.before, excess(a)) >
           std::tuple(b.severity, !b.before, excess(b));
}

std::string to_text(const Finding& finding) {
    const KindRow& row = row_of(finding.kind);
    std::string text(row.words);
    if (row.unit != Unit::None) {
        text += fmt::format(" {}, allowed {}", figure(finding.value, finding.kind),
                            figure(finding.limit, finding.kind));
    }
    if (finding.edge > 0) {
        text += fmt::format(", edge {}", finding.edge);
    }
    if (finding.face > 0) {
        text += fmt::format(", face {}", finding.face);
    }
    if (finding.other_face > 0) {
        text += fmt::format(" and face {}", finding.other_face);
    }
    if (!finding.at.isZero()) {
        text += fmt::format(", at ({:.6g}, {:.6g}, {:.6g})", finding.at.x(), finding.at.y(),
                            finding.at.z());
    }
    if (!finding.detail.empty()) {
        text += ": " + finding.detail;
    }
    return finding.before ? text + " (as in the input)" : text;
}

}  // namespace suture

#pragma once

#include <string_view>

namespace suture {

/// How smoothly two faces meet along an edge: in position, in tangent plane, in curvature.
enum class Continuity { G0 = 0, G1 = 1, G2 = 2 };

constexpr std::string_view to_string(Continuity continuity) {
    constexpr std::string_view kNames[] = {"G0", "G1", "G2"};
    return kNames[static_cast<int>(continuity)];
}

}  // namespace suture

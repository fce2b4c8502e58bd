#pragma once

#include "suture/base/result.h"

#include <numbers>

namespace suture {

inline constexpr double kPi = std::numbers::pi;

constexpr double radians(double degrees) {
    return degrees * kPi / 180.0;
}
constexpr double degrees(double radians) {
    return radians * 180.0 / kPi;
}

/// How far a result may be off. Always an argument, never a global.
struct Tolerance {
    double linear = 1e-3;            ///< largest gap, in model units
    double angular = radians(0.01);  ///< largest angle between normals, in radians
    double curvature = 0.02;         ///< largest curvature mismatch, relative: |k1-k2|/max
};

/// Refuses (Usage) anything that is not a positive finite number.
[[nodiscard]] Result<void> validate(const Tolerance& tolerance);

}  // namespace suture

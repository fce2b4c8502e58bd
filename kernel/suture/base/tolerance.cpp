#include "suture/base/tolerance.h"

#include <cmath>

namespace suture {

Result<void> validate(const Tolerance& tolerance) {
    const auto positive = [](double value) { return std::isfinite(value) && value > 0.0; };
    if (!positive(tolerance.linear)) {
        return fail(ErrorCode::Usage, "the length tolerance must be a positive number, not {}",
                    tolerance.linear);
    }
    if (!positive(tolerance.angular) || tolerance.angular > kPi) {
        return fail(ErrorCode::Usage,
                    "the angular tolerance must lie between 0 and 180 degrees, not at {}",
                    degrees(tolerance.angular));
    }
    if (!positive(tolerance.curvature)) {
        return fail(ErrorCode::Usage, "the curvature tolerance must be a positive number, not {}",
                    tolerance.curvature);
    }
    return {};
}

}  // namespace suture

#pragma once

#include "suture/base/tolerance.h"
#include "suture/fill/tube/border_fit.h"

#include <vector>

namespace suture::tube {

/// How well a net with these rows meets the sides, on one interval.
struct BorderError {
    double gap = 0.0;    ///< from the neighbour's edge
    double angle = 0.0;  ///< from the neighbour's normal; only where the side asks for it
    double fit_gap = 0.0, fit_angle = 0.0;  ///< from Border::at: what more intervals make smaller
};
[[nodiscard]] std::vector<std::vector<BorderError>> measure_border(const Border& border,
                                                                   const Divisions& divisions,
                                                                   const BorderRows& rows);

/// Divides the sides until the border is met within the tolerance.
///
/// Input    first: the intervals next to the corners are no longer than this, if they turn there
/// Result   fewer divisions than the tolerance needs where kMostColumns are not enough
[[nodiscard]] Divisions divide(const Border& border, const Tolerance& tolerance, double first,
                               const Way& way);

}  // namespace suture::tube

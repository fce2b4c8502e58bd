#pragma once

#include "suture/base/result.h"
#include "suture/fill/extend/trace.h"

#include <vector>

namespace suture::extend {

/// What part of the domain a hole is.
struct Region {
    enum class Kind {
        Disc,  ///< what one loop encloses, less islands
        Pole,  ///< between a loop around the surface and a pole
        Band,  ///< between two loops around the surface
    };
    Kind kind = Kind::Disc;
    int around = 0;              ///< Pole, Band: the coordinate that goes around; 0 = u
    int outer = 0;               ///< Disc: the enclosing loop
    int low = -1;                ///< Pole, Band: the loop that the hole lies above, in the other
    int high = -1;               ///<   coordinate, and the one that it lies below; -1: none
    const Pole* pole = nullptr;  ///< Pole: of the chart
};

/// Refuses  loops that bound no one face of the surface: saying which.
[[nodiscard]] Result<Region> region_of(const Chart& chart, const std::vector<Trace>& traces,
                                       bool reversed);

}  // namespace suture::extend

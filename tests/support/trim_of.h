#pragma once

#include "suture/model/patch.h"

#include <cstddef>
#include <stdexcept>
#include <vector>

namespace suture::test {

/// Where side `index` of a loop runs in a patch's domain.
inline const TrimCurve& trim_of(const Patch& patch, std::size_t loop, std::size_t index) {
    for (const std::vector<EdgeUse>& wire : patch.wires) {
        for (const EdgeUse& use : wire) {
            if (use.loop == static_cast<int>(loop) && use.index == static_cast<int>(index)) {
                return use.at;
            }
        }
    }
    throw std::out_of_range("the patch does not use this side");
}

}  // namespace suture::test

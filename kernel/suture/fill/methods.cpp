#include "suture/fill/extend.h"
#include "suture/fill/fill.h"
#include "suture/fill/plane.h"

#include <array>

namespace suture {

std::span<const FillMethod> fill_methods() {
    static constexpr std::array kMethods = {
        FillMethod{"extend", "Continues the surface on which all neighbours lie", "exact", "any",
                   Continuity::G2, &fill_extend},
        FillMethod{"plane", "Closes a planar loop by a plane", "exact", "any", Continuity::G0,
                   &fill_plane},
    };
    return kMethods;
}

}  // namespace suture

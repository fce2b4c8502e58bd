#include "suture/fill/extend.h"
#include "suture/fill/fill.h"
#include "suture/fill/manifold.h"
#include "suture/fill/mvs.h"
#include "suture/fill/plane.h"

#include <array>

namespace suture {

std::span<const FillMethod> fill_methods() {
    static constexpr std::array kMethods = {
        FillMethod{"extend", "Continues the surface on which all neighbours lie", "exact", "any",
                   Continuity::G2, &fill_extend},
        FillMethod{"plane", "Closes a planar loop by a plane", "exact", "any", Continuity::G0,
                   &fill_plane},
        FillMethod{"mvs", "The surface whose curvature varies least, as one biquintic face",
                   "Moreton & Sequin, Functional optimization for fair surface design, 1992", "any",
                   Continuity::G2, &fill_mvs},
        FillMethod{"manifold", "C^k patch of a star-shaped net, B-spline along its border",
                   "Cotrina-Navau, Pla-Garcia & Vigo-Anglada, N-sided patches with B-spline "
                   "boundaries, 2001",
                   "3 and more", Continuity::G2, &fill_manifold, kManifoldOptions,
                   /*in_auto=*/false},
    };
    return kMethods;
}

}  // namespace suture

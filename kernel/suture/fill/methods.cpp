#include "suture/fill/algebraic.h"
#include "suture/fill/concentric.h"
#include "suture/fill/extend.h"
#include "suture/fill/fill.h"
#include "suture/fill/loft.h"
#include "suture/fill/manifold.h"
#include "suture/fill/mvs.h"
#include "suture/fill/plane.h"
#include "suture/fill/quad.h"
#include "suture/fill/recognise.h"
#include "suture/fill/tube.h"

#include <array>

namespace suture {

std::span<const FillMethod> fill_methods() {
    static const std::array kMethods = {
        FillMethod{"extend", "Continues the surface on which all neighbours lie", "exact", "any",
                   Continuity::G2, &fill_extend},
        FillMethod{"recognise",
                   "Gives back the very face that was lost, where its border tells it",
                   "Pottmann & Randrup 1998; Lukacs, Marshall & Martin 1997",
                   "any",
                   Continuity::G2,
                   &fill_recognise,
                   {},
                   AutoUse::Recognising},
        FillMethod{"plane", "Closes a planar loop by a plane", "exact", "any", Continuity::G0,
                   &fill_plane},
        FillMethod{"loft", "Bridges two sides, chains or closed rims, cubic across",
                   "Ferguson, Multivariable curve interpolation, 1964", "4: two of them curves",
                   Continuity::G1, &fill_loft, kLoftOptions, AutoUse::Bridging},
        FillMethod{"mvs", "The surface whose curvature varies least, as one biquintic face",
                   "Moreton & Sequin, Functional optimization for fair surface design, 1992", "any",
                   Continuity::G2, &fill_mvs},
        FillMethod{"quad", "Coons' patch between four sides, one untrimmed face",
                   "Coons, Surfaces for computer-aided design of space forms, 1967", "4",
                   Continuity::G0, &fill_quad},
        FillMethod{"algebraic", "Piecewise algebraic surfaces between algebraic neighbours",
                   "Chen, Chen, Deng & Feng, Filling holes with piecewise algebraic surfaces, 2000",
                   "3 and more", Continuity::G2, &fill_algebraic, algebraic_options(),
                   AutoUse::Never},
        FillMethod{"concentric", "A disc-like surface whose spokes end on the medial axis",
                   "Martin & Cohen, Surface completion of an irregular boundary curve using a "
                   "concentric mapping, 2003",
                   "any, no islands", Continuity::G1, &fill_concentric, concentric_options(),
                   AutoUse::Never},
        FillMethod{"tube", "A tube around the hole that closes in a point, as one face",
                   "Szilvasi-Nagy, Filling holes with B-spline surfaces, 2002", "1 loop",
                   Continuity::G1, &fill_tube, kTubeOptions, AutoUse::Improving},
        FillMethod{"manifold", "C^k patch of a star-shaped net, B-spline along its border",
                   "Cotrina-Navau, Pla-Garcia & Vigo-Anglada, N-sided patches with B-spline "
                   "boundaries, 2001",
                   "3 and more", Continuity::G2, &fill_manifold, kManifoldOptions, AutoUse::Never},
    };
    return kMethods;
}

}  // namespace suture

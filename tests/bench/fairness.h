#pragma once

#include <TopoDS_Face.hxx>

namespace suture::bench {

/// How fair a face is; lengths in model units.
struct Fairness {
    double area = 0.0;
    double variation = 0.0;  ///< integral of |grad II|^2, 1/length^2: 0 for spheres and cylinders
    double bending = 0.0;    ///< integral of k1^2 + k2^2
    int sign_changes = 0;    ///< connected parts of one sign of the Gauss curvature, less one
};

/// Measured at the middles of an even grid in the parameters, `across` cells in each direction, as
/// far as they lie in the face. Gauss curvature counts where it is above a hundredth of what a
/// sphere of the same bending would have, and in parts of more than a thousandth of the cells.
///
/// Source  do Carmo, Differential geometry of curves and surfaces, 4-3 (Christoffel symbols).
[[nodiscard]] Fairness fairness_of(const TopoDS_Face& face, int across = 100);

}  // namespace suture::bench

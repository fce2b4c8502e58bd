#pragma once

#include <Eigen/Core>

namespace suture::mvs {

/// The partial derivatives of a surface at one point, in this order:
/// X_u X_v  X_uu X_uv X_vv  X_uuu X_uuv X_uvv X_vvv.
using Derivatives = Eigen::Matrix<double, 3, 9>;

/// The variation of curvature at one point: r . r = |grad II|^2 |X_u x X_v|.
///
/// Result   the components 111, 112, 122, 222 of grad II in an orthonormal frame, times the square
///          roots of their multiplicity (1, 3, 3, 1) and of the area element.
[[nodiscard]] Eigen::Vector4d curvature_variation(const Derivatives& X);

/// The same with its derivatives.
struct CurvatureVariation {
    Eigen::Vector4d residual;
    /// Row 3 d + c, column r: how residual r changes with component c of derivative vector d. Taken
    /// in a frame that turns with the surface as little as possible, which leaves r . r the same.
    Eigen::Matrix<double, 27, 4> jacobian;
};
[[nodiscard]] CurvatureVariation linearised_curvature_variation(const Derivatives& X);

}  // namespace suture::mvs

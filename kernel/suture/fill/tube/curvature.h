#pragma once

#include "suture/base/result.h"
#include "suture/fill/tube/fairing.h"
#include "suture/fill/tube/unknowns.h"

#include <Eigen/Core>
#include <Eigen/SparseCore>

namespace suture::tube {

/// x^T hessian x / 2 + gradient^T x
struct Quadratic {
    RealSparse hessian;
    RealVector gradient;
};

struct Bent {
    RealVector x;
    int steps = 0;
    double defect = 0.0;  ///< largest difference from a curvature asked for
};

/// Minimises an objective under prescribed normal curvatures at the pole, in the middle of each
/// interval around:  kappa |D(v)|^2 = <r_uu(0, v), N>,  D(v) = r_u(0, v).
///
/// Input    x: the minimum without the conditions, where Newton's method starts.
/// Refuses  if it does not converge.
/// Deviation: all conditions at once and free rows, instead of one patch after the other with the
///          tangents' magnitudes alone, which these conditions would fix already.
[[nodiscard]] Result<Bent> bend(const Net& net, const FairingTask& task, const Unknowns& unknowns,
                                const Quadratic& objective, const RealVector& x);

/// The normal curvature towards the normal at the pole along r_u(0, v).
[[nodiscard]] double pole_curvature(const Net& net, const Eigen::Vector3d& normal, int interval,
                                    double v);

}  // namespace suture::tube

#pragma once

#include "suture/base/progress.h"
#include "suture/fill/mvs/system.h"

namespace suture::mvs {

struct SolverOptions {
    int steps = 6;            ///< at most
    double settled = 1e-5;    ///< a step that moves the surface by less than this is the last one
    double least_gain = 0.0;  ///< nor is there one after which less than this part of the objective
                              ///< is to be gained by the next
    double damping = 1e-2;    ///< of the first step, against the energy's weight
};

struct Convergence {
    int steps = 0;
    bool settled = false;
    double last_move = 0.0;  ///< of the surface along its normal, in the solver's unit
    double work = 0.0;       ///< multiplications, about
};

/// Gauss and Newton's method with Levenberg's damping.
///
/// Source   Nocedal & Wright, Numerical optimization, ch. 10.
[[nodiscard]] Convergence minimise(const System& system, Net& net, const SolverOptions& options,
                                   const Progress& progress);

}  // namespace suture::mvs

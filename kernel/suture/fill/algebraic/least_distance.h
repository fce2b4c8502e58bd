#pragma once

#include "suture/base/progress.h"

#include <Eigen/Core>

#include <optional>

namespace suture::algebraic {

/// The shortest x with G x >= h; nothing if no x satisfies that, or if the run is cancelled.
///
/// Source  Goldfarb & Idnani, A numerically stable dual method for solving strictly convex
///         quadratic programs, 1983.
[[nodiscard]] std::optional<Eigen::VectorXd> least_distance(const Eigen::MatrixXd& G,
                                                            const Eigen::VectorXd& h,
                                                            const Progress& progress);

}  // namespace suture::algebraic

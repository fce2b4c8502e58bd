#pragma once

#include <Eigen/Core>

#include <optional>

namespace suture::algebraic {

/// The shortest x with G x >= h; nothing if no x satisfies that.
///
/// Source  Lawson & Hanson, Solving least squares problems, ch. 23: LDP by NNLS.
[[nodiscard]] std::optional<Eigen::VectorXd> least_distance(const Eigen::MatrixXd& G,
                                                            const Eigen::VectorXd& h);

}  // namespace suture::algebraic

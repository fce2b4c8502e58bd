#pragma once

#include "suture/fill/tube/fairing.h"

#include <Eigen/Core>
#include <Eigen/SparseCore>

namespace suture::tube {

/// The net's points as an affine function of what the fairing looks for:
///   points (x, y, z of each in turn) = map * x + fixed
/// with x = (end tangents' magnitudes, free rows, pole), as far as they are unknown.
struct Unknowns {
    Eigen::SparseMatrix<double> map;
    Eigen::VectorXd fixed;
    int pole = -1;  ///< where the pole's three coordinates begin in x; -1: it is fixed

    Unknowns(const Net& net, const FairingTask& task);

    [[nodiscard]] int count() const { return static_cast<int>(map.cols()); }
    [[nodiscard]] Eigen::Matrix3Xd points(const Eigen::VectorXd& x) const;
};

}  // namespace suture::tube

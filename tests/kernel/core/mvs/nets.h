#pragma once

#include "suture/fill/mvs/net.h"

#include <Eigen/Core>

#include <functional>
#include <utility>

namespace suture::mvs::test {

/// A net whose poles stand on a surface at the Greville abscissae: near it, and of its topology; a
/// plane that is linear in u and v it is.
inline Net net_on(const std::function<Eigen::Vector3d(double, double)>& surface, Axis u, Axis v) {
    Net net{std::move(u), std::move(v), {}};
    net.poles.resize(3, static_cast<Eigen::Index>(net.u.count()) * net.v.count());
    const auto greville = [](const Axis& axis, int i) {
        double sum = 0.0;
        for (int k = 1; k <= kDegree; ++k) {
            sum += axis.knots[static_cast<std::size_t>(i + k)];
        }
        return sum / kDegree;
    };
    for (int j = 0; j < net.v.count(); ++j) {
        for (int i = 0; i < net.u.count(); ++i) {
            net.poles.col(i + net.u.count() * j) = surface(greville(net.u, i), greville(net.v, j));
        }
    }
    return net;
}

}  // namespace suture::mvs::test

#include "suture/fill/algebraic/sector_map.h"

#include <cmath>

namespace suture::algebraic {

using Eigen::Vector2d;
using Eigen::Vector3d;

SectorMap::SectorMap(const Problem& problem, const Solution& solution, int sector, double width)
    : centre_(problem.view.centre), width_(width) {
    const Sector& s = solution.partition.sectors[static_cast<std::size_t>(sector)];
    directions_ = directions_of(s, solution.rays);
    if (s.side >= 0) {
        curve_ = problem.curves[static_cast<std::size_t>(s.side)];
    }
}

Vector3d SectorMap::base(double u) const {
    return curve_ ? on_ray(directions_, curve_(u) - centre_).b : Vector3d(1.0 - u, u, 0.0);
}

Vector3d SectorMap::operator()(double u, double v) const {
    const double aside = width_ * (u - 0.5);
    return (1.0 - v) * base(u) + v * Vector3d(-aside, aside, 1.0);
}

Vector2d SectorMap::inverse(const Vector3d& b) const {
    if (!curve_) {
        const double v = b[2];
        return {(b[1] + 0.5 * v * width_) / (1.0 - v + v * width_), v};
    }
    // The line of a given u that reaches b's height passes it on the left or on the right.
    double v = 0.0;
    const auto miss = [&](double u) {
        const Vector3d c = base(u);
        v = (b[2] - c[2]) / (1.0 - c[2]);
        return (1.0 - v) * c[1] + v * width_ * (u - 0.5) - b[1];
    };
    // The Illinois variant of the false position.
    double low = 0.0;
    double high = 1.0;
    double at_low = miss(low);
    double at_high = miss(high);
    if (at_low >= 0.0) {
        miss(low);
        return {low, v};
    }
    if (at_high <= 0.0) {
        miss(high);
        return {high, v};
    }
    constexpr int kSteps = 100;
    double u = 0.5;
    int last = 0;
    for (int n = 0; n < kSteps && high - low > 1e-15; ++n) {
        u = (low * at_high - high * at_low) / (at_high - at_low);
        const double at = miss(u);
        if (at == 0.0) {
            break;
        }
        const int side = at > 0.0 ? 1 : -1;
        (side > 0 ? high : low) = u;
        (side > 0 ? at_high : at_low) = at;
        if (side == last) {
            (side > 0 ? at_low : at_high) *= 0.5;
        }
        last = side;
        if (std::abs(at) < 1e-16) {
            break;
        }
    }
    miss(u);
    return {u, v};
}

}  // namespace suture::algebraic

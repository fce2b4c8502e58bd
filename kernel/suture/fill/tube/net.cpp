#include "suture/fill/tube/net.h"

#include "suture/spline/knots.h"

#include <algorithm>
#include <cmath>

namespace suture::tube {

using Eigen::Vector3d;

Net::Net(std::vector<double> across, Ring around)
    : knots_u(std::move(across)),
      ring(std::move(around)),
      points(Eigen::Matrix3Xd::Zero(3, rows() * columns())) {}

double Net::first_step() const {
    return knots_u[kDegreeU + 1] - knots_u[kDegreeU];
}

double Net::last_step() const {
    const auto last = static_cast<std::size_t>(rows());
    return knots_u[last] - knots_u[last - 1];
}

std::vector<double> knots_across(int layers) {
    constexpr double kBorder = 2.0;
    std::vector<double> knots(kDegreeU + 1, 0.0);
    for (int k = 0; k <= layers; ++k) {
        knots.push_back(kBorder - std::ldexp(1.0, -k));
    }
    knots.insert(knots.end(), kDegreeU + 1, kBorder);
    return knots;
}

/// lambda T of (13) and (17), here of each column: Deviation, docs/methods/tube.md.
Vector3d end_tangent(const Net& net, int column) {
    return (net.point(1, column) - net.point(0, column)) * (3.0 / net.first_step());
}

/// r(u, v) of (1).
SurfaceJet evaluate(const Net& net, double u, int interval, double v) {
    constexpr int kOrders = 2;
    const int span = find_span(net.knots_u, kDegreeU, u);
    const Eigen::MatrixXd across = basis_derivatives(net.knots_u, kDegreeU, span, u, kOrders);
    const Ring::Local around = net.ring.on(interval, v, kOrders);
    SurfaceJet jet;
    jet.point = jet.u = jet.v = jet.uu = jet.uv = jet.vv = Vector3d::Zero();
    for (int j = 0; j < 3; ++j) {
        for (int i = 0; i <= kDegreeU; ++i) {
            const Vector3d p = net.point(span - kDegreeU + i, around.first + j);
            const auto weight = [&](int a, int b) { return across(a, i) * around.basis(b, j); };
            jet.point += weight(0, 0) * p;
            jet.u += weight(1, 0) * p;
            jet.v += weight(0, 1) * p;
            jet.uu += weight(2, 0) * p;
            jet.uv += weight(1, 1) * p;
            jet.vv += weight(0, 2) * p;
        }
    }
    return jet;
}

SplineSurface to_surface(const Net& net) {
    const Ring& ring = net.ring;
    const int m = ring.columns();
    // At v = 0 columns 0 and 1 meet, or the double knot before it has column 0 alone.
    const double before = ring.interval(m - 1);
    const double after = ring.interval(0);
    const bool corner = before == 0.0;
    SplineSurface surface;
    surface.degree_u = kDegreeU;
    surface.degree_v = 2;
    surface.knots_u = net.knots_u;
    surface.knots_v.assign(3, 0.0);
    for (int k = 1; k < (corner ? m - 1 : m); ++k) {
        surface.knots_v.push_back(ring.start(k));
    }
    surface.knots_v.insert(surface.knots_v.end(), 3, ring.length());
    surface.poles.resize(3, surface.count_u() * surface.count_v());
    const int last = surface.count_v() - 1;
    for (int i = 0; i < net.rows(); ++i) {
        // The pole is one point to the last bit: near it rounding would turn the normals.
        const Vector3d seam =
            corner || i == 0
                ? Vector3d(net.point(i, 0))
                : Vector3d((after * net.point(i, 0) + before * net.point(i, 1)) / (before + after));
        for (int j = 0; j <= last; ++j) {
            surface.poles.col(surface.index(i, j)) =
                i == 0 || j == 0 || j == last ? seam : Vector3d(net.point(i, j));
        }
    }
    return surface;
}

}  // namespace suture::tube

#include "suture/fill/mvs/measure.h"

#include "suture/fill/mvs/polygon.h"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>

namespace suture::mvs {

Miss miss(const Net& net, const BoundarySample& sample) {
    const BasisRow u = basis_row(net.u, sample.uv.x());
    const BasisRow v = basis_row(net.v, sample.uv.y());
    const Eigen::Matrix<double, 3, kLocal> poles = net.local_poles(u.first, v.first);
    const Eigen::Matrix<double, 3, kDerivatives> X = poles * local_basis(u, v);
    const Eigen::Vector3d n = X.col(0).cross(X.col(1)).normalized();
    Miss result;
    result.gap = (poles * local_values(u, v) - sample.point).norm();
    if (sample.continuity >= Continuity::G1) {
        result.angle = std::atan2(n.cross(sample.normal).norm(), n.dot(sample.normal));
    }
    if (sample.continuity >= Continuity::G2) {
        // The normal curvature across the edge, in the direction `inward`.
        Eigen::Matrix<double, 3, 2> E = X.leftCols<2>();
        const Eigen::Vector2d d = (E.transpose() * E).ldlt().solve(E.transpose() * sample.inward);
        const double own = n.dot(X.col(2)) * d.x() * d.x() + 2.0 * n.dot(X.col(3)) * d.x() * d.y() +
                           n.dot(X.col(4)) * d.y() * d.y();
        result.curvature = std::abs(own - sample.inward.dot(sample.curvature * sample.inward));
    }
    return result;
}

Miss worst_miss(const Net& net, const std::vector<BoundarySample>& samples) {
    Miss worst;
    for (const BoundarySample& sample : samples) {
        const Miss m = miss(net, sample);
        worst.gap = std::max(worst.gap, m.gap);
        worst.angle = std::max(worst.angle, m.angle);
        worst.curvature = std::max(worst.curvature, m.curvature);
    }
    return worst;
}

double regularity(const Net& net, const std::vector<Eigen::Matrix2Xd>& polygons) {
    // Two points a span and direction see every fold that is not smaller than a span.
    constexpr int kPerSpan = 2;
    double least = std::numeric_limits<double>::infinity();
    double sum = 0.0;
    int count = 0;
    const auto look = [&](const Eigen::Vector2d& uv) {
        const BasisRow u = basis_row(net.u, uv.x());
        const BasisRow v = basis_row(net.v, uv.y());
        const Eigen::Matrix<double, 3, 2> E =
            net.local_poles(u.first, v.first) * local_basis(u, v).leftCols<2>();
        const double area = E.col(0).cross(E.col(1)).norm();
        least = std::min(least, area);
        sum += area;
        ++count;
    };
    for (const Eigen::Matrix2Xd& polygon : polygons) {
        for (Eigen::Index k = 0; k < polygon.cols(); ++k) {
            look(polygon.col(k));
        }
    }
    for (int j = 0; j < kPerSpan * net.v.spans(); ++j) {
        const int b = j / kPerSpan;
        const double t = (j % kPerSpan + 0.5) / kPerSpan;
        const double v = net.v.lower(b) + t * (net.v.upper(b) - net.v.lower(b));
        const std::vector<double> cut = crossings(polygons, v);
        for (int i = 0; i < kPerSpan * net.u.spans(); ++i) {
            const int a = i / kPerSpan;
            const double s = (i % kPerSpan + 0.5) / kPerSpan;
            const double u = net.u.lower(a) + s * (net.u.upper(a) - net.u.lower(a));
            if ((std::lower_bound(cut.begin(), cut.end(), u) - cut.begin()) % 2 == 1) {
                look({u, v});
            }
        }
    }
    return least * count / sum;
}

}  // namespace suture::mvs

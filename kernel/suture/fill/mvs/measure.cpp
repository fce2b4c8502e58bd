#include "suture/fill/mvs/measure.h"

#include "suture/fill/mvs/polygon.h"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

namespace suture::mvs {
namespace {

// Steps across a span at whose ends the normal is looked at.
constexpr int kLooksPerSpan = 3;

// Places along an axis at which the normal is looked at.
struct Looks {
    std::vector<double> at;
    std::vector<BasisRow> rows;

    explicit Looks(const Axis& axis) {
        for (int k = 0; k < axis.spans(); ++k) {
            for (int q = 0; q < kLooksPerSpan && !axis.empty(k); ++q) {
                at.push_back(axis.lower(k) + (axis.upper(k) - axis.lower(k)) * q / kLooksPerSpan);
                rows.push_back(basis_row(axis, k, at.back()));
            }
        }
    }
    // The last one that is not above t, and the next.
    [[nodiscard]] std::array<std::size_t, 2> beside(double t) const {
        const auto above =
            static_cast<std::size_t>(std::upper_bound(at.begin(), at.end(), t) - at.begin());
        return {std::max<std::size_t>(above, 1) - 1, std::min(above, at.size() - 1)};
    }
};

/// X_u x X_v.
Eigen::Vector3d normal_at(const Net& net, const BasisRow& u, const BasisRow& v) {
    const Eigen::Matrix<double, 3, 2> E =
        net.local_poles(u.first, v.first) * local_basis(u, v).leftCols<2>();
    return E.col(0).cross(E.col(1));
}

/// The elements of area that were looked at.
struct Areas {
    double least = std::numeric_limits<double>::infinity();
    double sum = 0.0;
    int count = 0;

    void look(const Eigen::Vector3d& normal) {
        const double area = normal.norm();
        least = std::min(least, area);
        sum += area;
        ++count;
    }
    /// Between a point and the next the normal does not turn over.
    void compare(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
        if (a.dot(b) < 0.0) {
            least = std::min(least, -std::min(a.norm(), b.norm()));
        }
    }
};

}  // namespace

Miss miss(const Net& net, const BoundarySample& sample) {
    const BasisRow u = basis_row(net.u, sample.uv.x());
    const BasisRow v = basis_row(net.v, sample.uv.y());
    const Eigen::Matrix<double, 3, kLocal> poles = net.local_poles(u.first, v.first);
    const Eigen::Matrix<double, 3, kDerivatives> X = poles * local_basis(u, v);
    const Eigen::Vector3d n = X.col(0).cross(X.col(1)).normalized();
    Miss result;
    result.gap = (poles * local_values(u, v) - sample.point).norm();
    if (sample.continuity >= Continuity::G1) {
        const double along = n.dot(sample.normal);
        const bool either_way = sample.loop < 0;
        result.angle =
            std::atan2(n.cross(sample.normal).norm(), either_way ? std::abs(along) : along);
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
    Areas areas;
    const Looks u(net.u);
    const Looks v(net.v);
    std::vector<std::optional<Eigen::Vector3d>> grid(u.rows.size() * v.rows.size());
    const auto at = [&](std::size_t i, std::size_t j) -> std::optional<Eigen::Vector3d>& {
        return grid[i + u.rows.size() * j];
    };
    for (std::size_t j = 0; j < v.rows.size(); ++j) {
        const std::vector<double> cut = crossings(polygons, v.at[j]);
        for (std::size_t i = 0; i < u.rows.size(); ++i) {
            if ((std::lower_bound(cut.begin(), cut.end(), u.at[i]) - cut.begin()) % 2 == 0) {
                continue;
            }
            at(i, j) = normal_at(net, u.rows[i], v.rows[j]);
            areas.look(*at(i, j));
            if (i > 0 && at(i - 1, j)) {
                areas.compare(*at(i, j), *at(i - 1, j));
            }
            if (j > 0 && at(i, j - 1)) {
                areas.compare(*at(i, j), *at(i, j - 1));
            }
        }
    }
    for (const Eigen::Matrix2Xd& polygon : polygons) {
        for (Eigen::Index k = 0; k < polygon.cols(); ++k) {
            const Eigen::Vector2d uv = polygon.col(k);
            const Eigen::Vector3d normal =
                normal_at(net, basis_row(net.u, uv.x()), basis_row(net.v, uv.y()));
            areas.look(normal);
            for (const std::size_t i : u.beside(uv.x())) {
                for (const std::size_t j : v.beside(uv.y())) {
                    if (at(i, j)) {
                        areas.compare(normal, *at(i, j));
                    }
                }
            }
        }
    }
    return areas.least * areas.count / areas.sum;
}

}  // namespace suture::mvs

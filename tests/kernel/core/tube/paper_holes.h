#pragma once

#include "suture/base/tolerance.h"
#include "suture/fill/tube/fairing.h"
#include "suture/fill/tube/pole.h"
#include "suture/model/ribbon.h"

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <Eigen/QR>

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

/// The holes of the paper's figures with dimensions of our own, and nets with a double control
/// point at each corner and unit knots around, as the paper has them.
namespace suture::tube::paper {

using Eigen::Vector3d;

/// A side: point and unit normal of the neighbour at s in [0,1].
struct Side {
    std::function<std::pair<Vector3d, Vector3d>(double)> at;
};

struct Corner {
    std::vector<Side> sides;  ///< counterclockwise, seen from outside
    Pole pole;
};

/// A quarter of a circle or less about a centre, from a to b (from the centre); the normal points
/// away from the centre, or towards it.
inline Side arc(const Vector3d& centre, const Vector3d& a, const Vector3d& b, double sign = 1.0) {
    const double angle = std::acos(a.normalized().dot(b.normalized()));
    return {[=](double s) {
        const Vector3d r =
            (std::sin((1.0 - s) * angle) * a + std::sin(s * angle) * b) / std::sin(angle);
        return std::pair<Vector3d, Vector3d>(centre + r, sign * r.normalized());
    }};
}
inline Side line(const Vector3d& a, const Vector3d& b, const Vector3d& normal) {
    return {[=](double s) { return std::pair<Vector3d, Vector3d>((1.0 - s) * a + s * b, normal); }};
}

/// The corner of a box with rounded edges: an octant of a sphere is the exact fill.
inline Corner suitcase() {
    constexpr double r = 6.0;
    const Vector3d centre(r, r, r);
    const Vector3d x(-r, 0, 0), y(0, -r, 0), z(0, 0, -r);
    return {{arc(centre, x, z), arc(centre, z, y), arc(centre, y, x)},
            {Vector3d::Constant(r - r / std::sqrt(3.0)), -Vector3d::Ones() / std::sqrt(3.0)}};
}

/// Five cylinders around the tip of a pyramid: a piece of a sphere is the exact fill.
inline Corner pentagon() {
    constexpr double r = 16.0;
    Corner corner{{}, {Vector3d(0, 0, r), Vector3d(0, 0, 1)}};
    const auto face = [](int k) {
        const double tilt = radians(35.0);
        const double turn = 2.0 * kPi * k / 5;
        return Vector3d(r * std::sin(tilt) * std::cos(turn), r * std::sin(tilt) * std::sin(turn),
                        r * std::cos(tilt));
    };
    for (int k = 0; k < 5; ++k) {
        corner.sides.push_back(arc(Vector3d::Zero(), face(k), face(k + 1)));
    }
    return corner;
}

/// Where two rounded edges and one hollow edge meet.
inline Corner house() {
    constexpr double r = 10.0;
    const double root = std::sqrt(2.0);
    const Vector3d x(r, 0, 0), y(0, r, 0), z(0, 0, r);
    return {{arc({-r, r, r}, -z, -y, -1.0), arc({-r, -r, r}, y, x),
             line({0, -r, r}, {0, -r, -r}, {1, 0, 0}), line({0, -r, -r}, {0, r, -r}, {1, 0, 0}),
             arc({-r, r, -r}, x, z)},
            {Vector3d(-2.928932, 0.857864, 0.857864), Vector3d(root, 1.0, 1.0) / 2.0}};
}

/// d: half of the way from the pole, projected on the tangent plane without loss of length.
inline Vector3d outward(const std::pair<Vector3d, Vector3d>& at, const Vector3d& pole) {
    const Vector3d from = at.first - pole;
    const Vector3d flat = from - at.second * at.second.dot(from);
    return flat * (0.5 * from.norm() / flat.norm());
}

struct Rows {
    Eigen::Matrix3Xd points, outward;
};

/// Least squares over 64 samples of each of the intervals of every side.
inline Rows fit(const Ring& ring, const Corner& corner, int columns_per_side) {
    const int nc = columns_per_side;
    const int sides = static_cast<int>(corner.sides.size());
    Rows rows{Eigen::Matrix3Xd(3, ring.columns()), Eigen::Matrix3Xd(3, ring.columns())};
    constexpr int kSamples = 64;
    for (int i = 0; i < sides; ++i) {
        const Side& side = corner.sides[static_cast<std::size_t>(i)];
        // Column q of the side is column i nc + 1 + q of the ring: the side begins at knot i nc.
        Eigen::MatrixXd system = Eigen::MatrixXd::Zero(nc * kSamples, nc);
        Eigen::MatrixXd right(nc * kSamples, 6);
        for (int k = 0; k < nc * kSamples; ++k) {
            const double v = i * nc + (k + 0.5) / kSamples;
            const Ring::Local local = ring.on(i * nc + k / kSamples, v, 0);
            double theta = 0.0;
            for (int j = 0; j < 3; ++j) {
                const int q = std::clamp(k / kSamples + j - 1, 0, nc - 1);
                system(k, q) += local.basis(0, j);
                theta += local.basis(0, j) * q / (nc - 1.0);
            }
            const auto at = side.at(theta);
            right.row(k) << at.first.transpose(),
                tube::paper::outward(at, corner.pole.point).transpose();
        }
        Eigen::MatrixXd columns(nc, 6);
        for (const int end : {0, nc - 1}) {
            const auto at = side.at(end == 0 ? 0.0 : 1.0);
            columns.row(end) << at.first.transpose(),
                tube::paper::outward(at, corner.pole.point).transpose();
        }
        right -= system.col(0) * columns.row(0) + system.col(nc - 1) * columns.row(nc - 1);
        columns.middleRows(1, nc - 2) =
            system.middleCols(1, nc - 2).colPivHouseholderQr().solve(right);
        for (int q = 0; q < nc; ++q) {
            const int column = ring.wrapped(i * nc + 1 + q);
            rows.points.col(column) = columns.row(q).head<3>();
            rows.outward.col(column) = columns.row(q).tail<3>();
        }
    }
    return rows;
}

/// The five-rowed net with its border rows, and straight columns between.
struct Paper {
    Net net;
    FairingTask task;
};
inline Paper prepare(const Corner& corner, int columns_per_side, Functional functional,
                     bool free_rows = true) {
    const int m = columns_per_side * static_cast<int>(corner.sides.size());
    Net net({0, 0, 0, 0, 1, 2, 2, 2, 2},
            Ring(std::vector<double>(static_cast<std::size_t>(m), 1.0)));
    const Rows rows = fit(net.ring, corner, columns_per_side);
    for (int j = 0; j < m; ++j) {
        net.point(4, j) = rows.points.col(j);
        net.point(3, j) = rows.points.col(j) - rows.outward.col(j) / 3.0;
        net.point(2, j) = rows.points.col(j) - rows.outward.col(j);
    }
    FairingTask task;
    task.functional = functional;
    task.free_rows = free_rows;
    task.closing = {corner.pole.point, corner.pole.normal,
                    directions_at(corner.pole, rows.points, rows.outward, {}).value()};
    return {std::move(net), std::move(task)};
}

}  // namespace suture::tube::paper

#include "suture/fill/tube/chart.h"

#include "suture/spline/knots.h"

#include <Eigen/LU>

#include <array>
#include <cmath>
#include <vector>

namespace suture::tube {
namespace {

using Eigen::Matrix2d;
using Eigen::Vector2d;

/// Gauss-Legendre on [0,1].
constexpr std::array kNodes = {0.069431844202973712, 0.33000947820757187, 0.66999052179242813,
                               0.93056815579702629};
constexpr std::array kWeights = {0.17392742256872693, 0.32607257743127307, 0.32607257743127307,
                                 0.17392742256872693};

/// The basis functions that live on one patch.
constexpr int kLocal = (kDegreeU + 1) * 3;
using Row = Eigen::Matrix<double, kLocal, 1>;
using RealRow = Eigen::Matrix<Real, kLocal, 1>;
using RealBlock = Eigen::Matrix<Real, kLocal, kLocal>;

struct PatchOfNet {
    int span, interval;
};

std::array<int, kLocal> indices_on(const Net& net, const PatchOfNet& patch) {
    std::array<int, kLocal> indices{};
    std::size_t n = 0;
    for (int j = 0; j < 3; ++j) {
        for (int i = 0; i <= kDegreeU; ++i) {
            indices[n++] = net.index(patch.span - kDegreeU + i, patch.interval + j);
        }
    }
    return indices;
}

/// Their derivatives by u and v at one place.
struct Derivatives {
    Row u, v, uu, uv, vv;
};

Derivatives derivatives_at(const Net& net, const PatchOfNet& patch, double u, double v) {
    constexpr int kOrders = 2;
    const Eigen::MatrixXd across = basis_derivatives(net.knots_u, kDegreeU, patch.span, u, kOrders);
    const Eigen::MatrixXd around = net.ring.on(patch.interval, v, kOrders).basis;
    Derivatives d;
    int n = 0;
    for (int j = 0; j < 3; ++j) {
        for (int i = 0; i <= kDegreeU; ++i, ++n) {
            d.u[n] = across(1, i) * around(0, j);
            d.v[n] = across(0, i) * around(1, j);
            d.uu[n] = across(2, i) * around(0, j);
            d.uv[n] = across(1, i) * around(1, j);
            d.vv[n] = across(0, i) * around(2, j);
        }
    }
    return d;
}

/// The second derivatives in the plane, and the chart's Jacobian.
struct InPlane {
    Row xx, xy, yy;
    double area;
};

InPlane in_plane(const Derivatives& d, const Eigen::Matrix<double, 2, kLocal>& chart) {
    Matrix2d J;  // NOLINT(readability-identifier-naming): the Jacobian
    J << chart * d.u, chart * d.v;
    const Matrix2d K = J.inverse();  // NOLINT(readability-identifier-naming): its inverse
    const Row x = K(0, 0) * d.u + K(1, 0) * d.v;
    const Row y = K(0, 1) * d.u + K(1, 1) * d.v;
    const auto without_chart = [&](const Row& second) -> Row {
        const Vector2d bend = chart * second;
        return second - bend.x() * x - bend.y() * y;
    };
    const Row uu = without_chart(d.uu);
    const Row uv = without_chart(d.uv);
    const Row vv = without_chart(d.vv);
    const auto second = [&](int a, int b) -> Row {
        return K(0, a) * K(0, b) * uu + (K(0, a) * K(1, b) + K(1, a) * K(0, b)) * uv +
               K(1, a) * K(1, b) * vv;
    };
    return {second(0, 0), second(0, 1), second(1, 1), std::abs(J.determinant())};
}

RealBlock patch_matrix(const Net& net, const PatchOfNet& patch,
                       const Eigen::Matrix<double, 2, kLocal>& chart) {
    const double low = net.knots_u[static_cast<std::size_t>(patch.span)];
    const double h = net.knots_u[static_cast<std::size_t>(patch.span) + 1] - low;
    const double g = net.ring.interval(patch.interval);
    RealBlock sum = RealBlock::Zero();
    for (std::size_t p = 0; p < kNodes.size(); ++p) {
        for (std::size_t q = 0; q < kNodes.size(); ++q) {
            const InPlane at =
                in_plane(derivatives_at(net, patch, low + h * kNodes[p],
                                        net.ring.start(patch.interval) + g * kNodes[q]),
                         chart);
            const Real weight = kWeights[p] * kWeights[q] * h * g * at.area;
            const RealRow xx = at.xx.cast<Real>();
            const RealRow xy = at.xy.cast<Real>();
            const RealRow yy = at.yy.cast<Real>();
            sum += weight *
                   (xx * xx.transpose() + Real(2) * xy * xy.transpose() + yy * yy.transpose());
        }
    }
    return sum;
}

}  // namespace

Chart Chart::radial(const Net& net, const Eigen::Matrix2Xd& border) {
    Eigen::Matrix2Xd smooth = border;
    for (const Ring::Double& corner : net.ring.doubles()) {
        smooth.col(corner.column) =
            corner.before * border.col(net.ring.wrapped(corner.column - 1)) +
            (1.0 - corner.before) * border.col(net.ring.wrapped(corner.column + 1));
    }
    Chart chart{Eigen::Matrix2Xd(2, net.points.cols())};
    for (int i = 0; i < net.rows(); ++i) {
        const auto k = static_cast<std::size_t>(i);
        const double greville =
            (net.knots_u[k + 1] + net.knots_u[k + 2] + net.knots_u[k + 3]) / 3.0;
        const Eigen::Matrix2Xd& row = i + 2 < net.rows() ? smooth : border;
        for (int j = 0; j < net.columns(); ++j) {
            chart.points.col(net.index(i, j)) = greville / net.border() * row.col(j);
        }
    }
    return chart;
}

RealSparse plate_matrix(const Net& net, const Chart& chart) {
    std::vector<Eigen::Triplet<Real>> entries;
    for (int interval = 0; interval < net.columns(); ++interval) {
        for (int span = kDegreeU; span < net.rows() && net.ring.interval(interval) > 0.0; ++span) {
            const PatchOfNet patch{span, interval};
            const auto indices = indices_on(net, patch);
            Eigen::Matrix<double, 2, kLocal> points;
            for (int n = 0; n < kLocal; ++n) {
                points.col(n) = chart.points.col(indices[static_cast<std::size_t>(n)]);
            }
            const RealBlock block = patch_matrix(net, patch, points);
            for (int r = 0; r < kLocal; ++r) {
                for (int c = 0; c < kLocal; ++c) {
                    entries.emplace_back(indices[static_cast<std::size_t>(r)],
                                         indices[static_cast<std::size_t>(c)], block(r, c));
                }
            }
        }
    }
    RealSparse matrix(net.points.cols(), net.points.cols());
    matrix.setFromTriplets(entries.begin(), entries.end());
    return matrix;
}

}  // namespace suture::tube

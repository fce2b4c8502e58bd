#include "suture/fill/tube/stripe.h"

#include "suture/fill/tube/fairing.h"

#include "kernel/core/tube/paper_holes.h"
#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace suture::tube {
namespace {

using Eigen::Vector3d;

std::vector<double> even(double from, double to, int count) {
    std::vector<double> t;
    for (int k = 0; k <= count; ++k) {
        t.push_back(from + (to - from) * k / count);
    }
    return t;
}

/// A curve on a torus, R = 10 and r = 4, and its derivatives: both angles are t.
Vector3d on_torus(double t) {
    const double rho = 10.0 + 4.0 * std::cos(t);
    return {rho * std::cos(t), rho * std::sin(t), 4.0 * std::sin(t)};
}
Vector3d torus_first(double t) {
    return {-10.0 * std::sin(t) - 4.0 * std::sin(2.0 * t),
            10.0 * std::cos(t) + 4.0 * std::cos(2.0 * t), 4.0 * std::cos(t)};
}
Vector3d torus_second(double t) {
    return {-10.0 * std::cos(t) - 8.0 * std::cos(2.0 * t),
            -10.0 * std::sin(t) - 8.0 * std::sin(2.0 * t), -4.0 * std::sin(t)};
}

Vector3d value(const Eigen::Matrix3Xd& columns, int k, double x) {
    return 0.5 * (1.0 - x) * (1.0 - x) * columns.col(k) + (0.5 + x - x * x) * columns.col(k + 1) +
           0.5 * x * x * columns.col(k + 2);
}

/// Root mean square difference, by the curve's length, in percent; unit intervals.
double error_on_torus(const Eigen::Matrix3Xd& columns, const std::vector<double>& t) {
    constexpr int kSamples = 400;
    double square = 0.0;
    double length = 0.0;
    const int pieces = static_cast<int>(t.size()) - 1;
    for (int k = 0; k < pieces; ++k) {
        for (int q = 0; q < kSamples; ++q) {
            const double x = (q + 0.5) / kSamples;
            const double at = t[static_cast<std::size_t>(k)] + x * (t[1] - t[0]);
            square += (value(columns, k, x) - on_torus(at)).squaredNorm() / kSamples / pieces;
            length += torus_first(at).norm() * (t[1] - t[0]) / kSamples;
        }
    }
    return 100.0 * std::sqrt(square) / length;
}

TEST(TubeStripe, MarchesAlongATorusAsExactlyAsThePaperSays) {
    const double wanted[] = {0.0898, 0.0110};
    for (const int k : {0, 1}) {
        const int count = 6 * (k + 1);
        const auto t = even(0.0, 0.5 * kPi, count);
        const auto pieces = taylor_pieces(on_torus, torus_first, torus_second, t);
        const std::vector<double> unit(static_cast<std::size_t>(count), 1.0);
        EXPECT_NEAR(error_on_torus(march(pieces, unit, Ends::Repeated), t), wanted[k], 1e-4)
            << count;
    }
}

TEST(TubeStripe, FittedAllAtOnceIsBetterStill) {
    const double wanted[] = {0.0117, 0.0015};
    for (const int k : {0, 1}) {
        const int count = 6 * (k + 1);
        const auto t = even(0.0, 0.5 * kPi, count);
        const std::vector<double> unit(static_cast<std::size_t>(count), 1.0);
        const auto columns = fit_all(bezier_pieces(on_torus, t), unit, Ends::Repeated);
        EXPECT_LT(error_on_torus(columns, t), 1.3 * wanted[k]) << count;
    }
}

/// A closed spline with uneven knots, as pieces.
TEST(TubeStripe, GivesBackASplineExactlyByEitherWay) {
    const std::vector<double> intervals = {1.0, 0.4, 2.5, 1.3, 0.7};
    const Ring ring(intervals);
    Eigen::Matrix3Xd columns(3, 5);
    columns << 1, 2, -1, -3, 0, 0, 3, 4, 1, -2, 0.5, -1, 2, 0, 1;
    std::vector<Piece> pieces;
    for (int k = 0; k < 5; ++k) {
        const Ring::Local local = ring.on(k, ring.start(k), 2);
        const double g = intervals[static_cast<std::size_t>(k)];
        Piece piece = Piece::Zero();
        for (int j = 0; j < 3; ++j) {
            const Vector3d c = columns.col(ring.wrapped(k + j));
            piece.col(0) += local.basis(0, j) * c;
            piece.col(1) += g * local.basis(1, j) * c;
            piece.col(2) += 0.5 * g * g * local.basis(2, j) * c;
        }
        pieces.push_back(piece);
    }
    for (const auto& found :
         {march(pieces, intervals, Ends::Closed), fit_all(pieces, intervals, Ends::Closed)}) {
        for (int j = 0; j < 7; ++j) {
            EXPECT_LT((found.col(j) - columns.col(j % 5)).norm(), 1e-13) << j;
        }
    }
}

TEST(TubeStripe, ChordLengthsAreInProportionToThePieces) {
    const auto pieces =
        bezier_pieces([](double t) { return Vector3d(t, 0, 0); }, {0.0, 1.0, 4.0, 5.0});
    const auto lengths = chord_lengths(pieces);
    EXPECT_NEAR(lengths[0], 0.6, 1e-14);
    EXPECT_NEAR(lengths[1], 1.8, 1e-14);
}

TEST(TubeStripe, BezierPiecesOfAQuadraticAreIt) {
    const auto quadratic = [](double t) { return Vector3d(1 + t, t * t, 2 - t + 3 * t * t); };
    const auto pieces = bezier_pieces(quadratic, {0.0, 0.5, 2.0});
    for (const double x : {0.0, 0.3, 1.0}) {
        const Vector3d at = pieces[1] * Vector3d(1.0, x, x * x);
        EXPECT_LT((at - quadratic(0.5 + 1.5 * x)).norm(), 1e-14);
    }
}

/// r(u, v) of a uniform bicubic-by-quadratic patch, and derivatives: equation (1).
Vector3d patch(const std::array<std::array<Vector3d, 3>, 4>& points, double u, double v, int a,
               int b) {
    const auto powers = [](double x, int d, int n) {
        Eigen::Vector4d p = Eigen::Vector4d::Zero();
        for (int k = d; k <= n; ++k) {
            p[k] = std::tgamma(k + 1) / std::tgamma(k - d + 1) * std::pow(x, k - d);
        }
        return p;
    };
    Eigen::Matrix4d cubic;
    cubic << 1, 4, 1, 0, -3, 0, 3, 0, 3, -6, 3, 0, -1, 3, -3, 1;
    Eigen::Matrix3d quadratic;
    quadratic << 1, 1, 0, -2, 2, 0, 1, -2, 1;
    const Eigen::RowVector4d across = powers(u, a, 3).transpose() * cubic / 6.0;
    const Eigen::RowVector3d around = powers(v, b, 2).head<3>().transpose() * quadratic / 2.0;
    Vector3d sum = Vector3d::Zero();
    for (std::size_t i = 0; i < 4; ++i) {
        for (std::size_t j = 0; j < 3; ++j) {
            sum += across[static_cast<Eigen::Index>(i)] * around[static_cast<Eigen::Index>(j)] *
                   points[i][j];
        }
    }
    return sum;
}

TEST(TubeStripe, ClosingPointsMeetTheConditionsOfOnePatch) {
    const Vector3d pole(1, -2, 3);
    const Vector3d first(0.5, 1.5, 0);
    const Vector3d other(-1, 0.7, 0);
    const std::array<Vector3d, 3> third = {Vector3d(4, 0, 1), Vector3d(3, 2, 0), Vector3d(1, 3, 2)};
    const auto rows = closing_points(pole, first, other, third);
    const std::array<std::array<Vector3d, 3>, 4> net = {
        rows[0], rows[1], third, {Vector3d(7, 7, 7), Vector3d(8, 1, 0), Vector3d(-1, 5, 2)}};
    EXPECT_LT((patch(net, 0, 0, 0, 0) - pole).norm(), 1e-14);   // (12)
    EXPECT_LT((patch(net, 0, 0, 1, 0) - first).norm(), 1e-14);  // (13)
    EXPECT_LT(patch(net, 0, 0, 0, 1).norm(), 1e-14);            // (14)
    EXPECT_LT(patch(net, 0, 0, 1, 1).norm(), 1e-14);            // (15)
    EXPECT_LT((patch(net, 0, 1, 0, 0) - pole).norm(), 1e-14);   // (16)
    EXPECT_LT((patch(net, 0, 1, 1, 0) - other).norm(), 1e-14);  // (17)
}

TEST(TubeStripe, PhantomRowsHaveTheSameSurface) {
    auto paper = paper::prepare(paper::suitcase(), 4, Functional::F2);
    const Net net = close(paper.net, paper.task)->net;
    const Eigen::Matrix3Xd rows = phantom_rows(net);
    for (int k = 0; k < net.columns(); ++k) {
        for (const int across : {0, 1}) {
            std::array<std::array<Vector3d, 3>, 4> points;
            for (int i = 0; i < 4; ++i) {
                for (int j = 0; j < 3; ++j) {
                    points[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)] =
                        rows.col(net.index(across + i, k + j));
                }
            }
            for (const double x : {0.1, 0.6, 0.9}) {
                const SurfaceJet jet = evaluate(net, across + x, k, k + 0.3);
                EXPECT_LT((patch(points, x, 0.3, 0, 0) - jet.point).norm(), 1e-13);
                EXPECT_LT((patch(points, x, 0.3, 1, 1) - jet.uv).norm(), 1e-13);
            }
        }
    }
}

}  // namespace
}  // namespace suture::tube

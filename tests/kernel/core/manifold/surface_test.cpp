#include "suture/spline/surface.h"

#include <Eigen/Geometry>

#include "kernel/core/manifold/support.h"

namespace suture::manifold {
namespace {

using Eigen::Matrix3Xd;
using Eigen::Vector2d;
using Eigen::Vector3d;
using test::inside;
using test::make_star;
using test::rough_points;
using test::uneven;

struct Golden {
    int n, k;
    Vector3d point;
    double sum;
};

TEST(ManifoldSurface, GivesTheGoldenNumbers) {
    const Golden goldens[] = {
        {3, 1, {0.31794164, 0.23663695, 0.06356933}, 1.130529},
        {3, 2, {0.22387765, 0.14867645, 0.04381029}, 1.585415},
        {3, 3, {0.35255762, 0.27288696, 0.06757662}, 0.865415},
        {5, 0, {0.13665263, 0.08487360, 0.02675041}, 1.932111},
        {5, 1, {0.35555014, 0.23681813, 0.07008736}, 1.417768},
        {5, 2, {0.20148602, 0.13345938, 0.03877591}, 2.432386},
        {5, 3, {0.35295356, 0.23471640, 0.06609377}, 1.335211},
        {6, 2, {0.20901131, 0.13709611, 0.04008272}, 2.703256},
        {7, 2, {0.20786515, 0.14021145, 0.03963371}, 2.932354},
    };
    for (const Golden& golden : goldens) {
        const int h = golden.k / 2 + 1;
        const Star star = make_star({golden.k,
                                     2 * golden.k + 3,
                                     std::vector<int>(static_cast<std::size_t>(golden.n), 3),
                                     h / (4.0 * std::cos(M_PI / golden.n)),
                                     {}});
        Matrix3Xd points(3, star.count());
        for (int m = 0; m < star.n(); ++m) {
            for (int i = 0; i < star.charts_x(); ++i) {
                for (int j = 0; j < star.charts_y(m); ++j) {
                    const Vector2d c = star.chart_centre(m, i, j);
                    points.col(star.point_of(m, i, j)) =
                        Vector3d(c.x(), c.y(), 0.3 * std::sin(0.7 * c.x()) * std::cos(0.5 * c.y()));
                }
            }
        }
        const StarSurface surface(star, points);
        EXPECT_LT((surface.at({0.3, 0.2}) - golden.point).norm(), 2e-8)
            << "n = " << golden.n << ", k = " << golden.k << ": "
            << surface.at({0.3, 0.2}).transpose();
        EXPECT_NEAR(surface.sum({0.3, 0.2})[3], golden.sum, 1e-6);
    }
}

/// The B-spline of side m alone: all its charts, kept or not, with weight one.
SplineSurface plain(const Star& star, const Matrix3Xd& points, int m) {
    SplineSurface spline;
    spline.degree_u = spline.degree_v = star.degree();
    spline.knots_u = star.knots_x(m);
    spline.knots_v = star.knots_y(m);
    spline.poles.resize(3, star.charts_x() * star.charts_y(m));
    for (int j = 0; j < star.charts_y(m); ++j) {
        for (int i = 0; i < star.charts_x(); ++i) {
            spline.poles.col(spline.index(i, j)) = points.col(star.point_of(m, i, j));
        }
    }
    return spline;
}

StarSize with_given_knots(int k, int n) {
    StarSize size = uneven(k, n, 3);
    for (int m = 0; m < n; ++m) {
        GivenKnots knots;
        for (int i = 0; i <= size.layers; ++i) {
            knots.depth.push_back(i + 0.3 * std::sin(1.0 * i * (m + 1)));
        }
        knots.depth[0] = 0.0;
        const int r = size.columns[static_cast<std::size_t>(m)];
        for (int j = 0; j <= r; ++j) {
            knots.middle.push_back(-1.0 + 2.0 * std::pow(static_cast<double>(j) / r, 1.3));
        }
        size.given.push_back(knots);
    }
    size.aperture *= 0.7;
    return size;
}

TEST(ManifoldSurface, IsThePlainBSplineInItsBorderZone) {
    for (const int n : {3, 4, 5, 6, 7}) {
        for (int k = 0; k <= 4; ++k) {
            for (const StarSize& size : {uneven(k, n), with_given_knots(k, n)}) {
                const Star star = make_star(size);
                const Matrix3Xd points = rough_points(star);
                const StarSurface surface(star, points);
                for (int m = 0; m < n; ++m) {
                    const SplineSurface spline = plain(star, points, m);
                    const double low = -star.f_y() - std::sin(star.alpha()) * star.border(m - 1);
                    const double high = star.f_y() + std::sin(star.alpha()) * star.border(m + 1);
                    for (int a = 0; a <= 6; ++a) {
                        const double x = star.inner() +
                                         (star.border(m) - star.inner()) * (a + 1e-9) / (6 + 2e-9);
                        for (int b = 0; b <= 30; ++b) {
                            const double y = low + (high - low) * (b + 1e-9) / (30 + 2e-9);
                            const Vector3d p = surface.at(star.from_side(m, {x + star.mu(y), y}));
                            const Vector3d q = evaluate(spline, x, y).point;
                            ASSERT_LT((p - q).norm(), 1e-12)
                                << "n = " << n << ", k = " << k << ", x = " << x << ", y = " << y;
                        }
                    }
                }
            }
        }
    }
}

/// The corrected bound is sharp: two layers further in, the surface is no longer that B-spline.
TEST(ManifoldSurface, IsAnotherSurfaceInsideTheBorderZone) {
    for (const int n : {3, 5}) {
        for (int k = 0; k <= 3; ++k) {
            const Star star = make_star(uneven(k, n));
            const Matrix3Xd points = rough_points(star);
            const StarSurface surface(star, points);
            double apart = 0.0;
            const SplineSurface spline = plain(star, points, 0);
            for (int b = 0; b <= 40; ++b) {
                const double y = (b - 20) * 0.05 * (star.f_y() + std::sin(star.alpha()));
                const double x = star.inner() - 1.9;
                const Vector3d p = surface.at({x + star.mu(y), y});
                apart = std::max(apart, (p - evaluate(spline, x, y).point).norm());
            }
            EXPECT_GT(apart, 1e-6) << "n = " << n << ", k = " << k;
        }
    }
}

TEST(ManifoldSurface, IsTheUniformBSplineForFourSides) {
    for (const int k : {2, 4}) {
        const Star star = make_star({k, Star::least_layers(k, 4) + 1, {1, 1, 1, 1}, 1.0, {}});
        const Matrix3Xd points = rough_points(star);
        const StarSurface surface(star, points);
        // Vertices of X are the points with half-integer coordinates.
        const int s = star.layers();
        SplineSurface spline;
        spline.degree_u = spline.degree_v = k + 1;
        const int count = 2 * s + 2;
        for (int i = 0; i < count + k + 2; ++i) {
            spline.knots_u.push_back(i - s - 0.5 - star.h());
        }
        spline.knots_v = spline.knots_u;
        spline.poles.resize(3, count * count);
        for (int m = 0; m < 4; ++m) {
            for (int i = 0; i < star.charts_x(); ++i) {
                for (int j = 0; j < star.charts_y(m); ++j) {
                    const Vector2d c = star.chart_centre(m, i, j);
                    spline.poles.col(spline.index(static_cast<int>(std::lround(c.x() + s + 0.5)),
                                                  static_cast<int>(std::lround(c.y() + s + 0.5)))) =
                        points.col(star.point_of(m, i, j));
                }
            }
        }
        for (const Vector2d& p : inside(star, 500)) {
            EXPECT_LT((surface.at(p) - evaluate(spline, p.x(), p.y()).point).norm(), 1e-12);
            EXPECT_NEAR(surface.sum(p)[3], 1.0, 1e-13);
        }
    }
}

TEST(ManifoldSurface, IsAPartitionOfUnity) {
    for (const int n : {3, 4, 5, 6, 7}) {
        for (int k = 0; k <= 4; ++k) {
            const Star star = make_star(uneven(k, n));
            Matrix3Xd points = Matrix3Xd::Zero(3, star.count());
            points.row(0).setConstant(1.0);
            points.row(1).setConstant(-2.5);
            const StarSurface surface(star, points);
            for (const Vector2d& p : inside(star, 300)) {
                EXPECT_LT((surface.at(p) - Vector3d(1.0, -2.5, 0.0)).norm(), 1e-12);
            }
        }
    }
}

TEST(ManifoldSurface, MovesWithItsControlPoints) {
    Eigen::Matrix3d linear;
    linear << 2.0, 0.3, -1.0, 0.4, -1.5, 0.2, 0.1, 0.7, 3.0;
    const Vector3d shift(10.0, -20.0, 5.0);
    for (int k = 0; k <= 4; ++k) {
        const Star star = make_star(uneven(k, 5));
        const Matrix3Xd points = rough_points(star);
        StarSurface moved(star, points);
        moved.move((linear * points).colwise() + shift);
        const StarSurface surface(star, points);
        for (const Vector2d& p : inside(star, 200)) {
            EXPECT_LT((moved.at(p) - linear * surface.at(p) - shift).norm(), 1e-12 * 100.0);
        }
    }
}

/// A convex combination: no direction reaches further than the control points.
TEST(ManifoldSurface, StaysInTheConvexHull) {
    std::mt19937 random(5);
    std::normal_distribution<double> normal;
    for (const int n : {3, 5, 6}) {
        for (int k = 0; k <= 3; ++k) {
            const Star star = make_star(uneven(k, n));
            const Matrix3Xd points = rough_points(star);
            const StarSurface surface(star, points);
            for (int trial = 0; trial < 20; ++trial) {
                const Vector3d direction(normal(random), normal(random), normal(random));
                const double reach = (direction.transpose() * points).maxCoeff();
                for (const Vector2d& p : inside(star, 50)) {
                    ASSERT_LE(direction.dot(surface.at(p)), reach + 1e-12);
                }
            }
        }
    }
}

/// The largest jump of all derivatives of one order across the curve x - mu(y) = x_of of side m, or
/// across the line y = y_of.
double jump(const StarSurface& surface, int m, const Vector2d& on_side, const Vector2d& step,
            int order) {
    const Star& star = surface.star();
    const auto to_plane = [&](const Vector2d& q) {
        return star.from_side(m, {q.x() + star.mu(q.y()), q.y()});
    };
    const Vector2d p = to_plane(on_side);
    const auto expand = [&](double sign) {
        return surface.expand(variable(p.x(), 0, order), variable(p.y(), 1, order),
                              to_plane(on_side + sign * step));
    };
    const Series<3> a = expand(1.0);
    const Series<3> b = expand(-1.0);
    double largest = 0.0;
    for (int i = 0; i <= order; ++i) {
        largest =
            std::max(largest, (a.derivative(i, order - i) - b.derivative(i, order - i)).norm());
    }
    return largest;
}

/// The largest jumps across curves: of derivatives up to the order k, and of those beyond it.
struct Jumps {
    double within = 0.0;
    double beyond = 0.0;
};

void measure_jumps(const StarSurface& surface, int m, const Vector2d& at, const Vector2d& step,
                   int k, Jumps& jumps) {
    for (int order = 0; order <= k; ++order) {
        jumps.within = std::max(jumps.within, jump(surface, m, at, step, order));
    }
    jumps.beyond = std::max(jumps.beyond, jump(surface, m, at, step, k + 1));
}

Jumps jumps_across_inner_curves(const StarSurface& surface, const Star& star, int n, int k) {
    Jumps jumps;
    for (int m = 0; m < n; ++m) {
        for (const double x : star.knots_x(m)) {
            if (x < -0.2 || x > star.border(m) - 0.5) {
                continue;
            }
            for (const double t : {-1.6, -0.7, 0.13, 0.6, 1.9}) {
                measure_jumps(surface, m, {x, t * star.f_y()}, {1e-6, 0.0}, k, jumps);
            }
        }
        for (const double y : star.knots_y(m)) {
            if (std::abs(y) > star.f_y() + 1.5) {
                continue;
            }
            for (const double x : {-0.15, 0.4, 1.3}) {
                measure_jumps(surface, m, {x, y}, {0.0, 1e-6}, k, jumps);
            }
        }
    }
    return jumps;
}

TEST(ManifoldSurface, IsCkAcrossAllInnerCurvesAndNoMore) {
    for (const int n : {3, 5, 6, 7}) {
        for (int k = 0; k <= 3; ++k) {
            const Star star = make_star(uneven(k, n));
            const StarSurface surface(star, rough_points(star));
            const Jumps jumps = jumps_across_inner_curves(surface, star, n, k);
            EXPECT_LT(jumps.within, 1e-8) << "n = " << n << ", k = " << k;
            EXPECT_GT(jumps.beyond, 1e-2) << "n = " << n << ", k = " << k;
        }
    }
}

/// Against differences of the value, which takes another way through the code.
TEST(ManifoldSurface, HasTheDerivativesOfItsValues) {
    for (const int n : {3, 5}) {
        for (int k = 1; k <= 4; ++k) {
            const Star star = make_star(uneven(k, n));
            const StarSurface surface(star, rough_points(star));
            for (const Vector2d& p : inside(star, 40)) {
                const Series<3> series = surface.expand(p, 2);
                constexpr double kStep = 1e-6;
                const Vector2d x(kStep, 0.0);
                const Vector2d y(0.0, kStep);
                EXPECT_LT((series.term(0, 0) - surface.at(p)).norm(), 1e-13);
                EXPECT_LT((series.derivative(1, 0) -
                           (surface.at(p + x) - surface.at(p - x)) / (2.0 * kStep))
                              .norm(),
                          1e-5);
                EXPECT_LT((series.derivative(0, 1) -
                           (surface.at(p + y) - surface.at(p - y)) / (2.0 * kStep))
                              .norm(),
                          1e-5);
                const auto slope = [&](const Vector2d& q) {
                    return surface.expand(q, 1).derivative(1, 0);
                };
                if (k >= 2) {
                    EXPECT_LT(
                        (series.derivative(1, 1) - (slope(p + y) - slope(p - y)) / (2.0 * kStep))
                            .norm(),
                        1e-4);
                }
            }
        }
    }
}

/// Which points lie in the outermost `count` rows.
std::vector<bool> last_rows(const Star& star, int n, int count) {
    std::vector<bool> found(static_cast<std::size_t>(star.count()), false);
    const int rows = star.charts_x();
    for (int m = 0; m < n; ++m) {
        for (int i = rows - count; i < rows; ++i) {
            for (int j = 0; j < star.charts_y(m); ++j) {
                found[static_cast<std::size_t>(star.point_of(m, i, j))] = true;
            }
        }
    }
    return found;
}

/// The free points shape the middle and leave the border as it is, to the order k.
TEST(ManifoldSurface, IsHeldAtItsBorderByKPlusOneRows) {
    for (const int n : {3, 5}) {
        for (int k = 0; k <= 3; ++k) {
            const Star star = make_star(uneven(k, n));
            Matrix3Xd points = rough_points(star);
            const StarSurface before(star, points);
            const std::vector<bool> held = last_rows(star, n, k + 1);
            const Matrix3Xd other = rough_points(star, 99);
            for (int point = 0; point < star.count(); ++point) {
                if (!held[static_cast<std::size_t>(point)]) {
                    points.col(point) = other.col(point) + Vector3d(0.0, 0.0, 3.0);
                }
            }
            const StarSurface after(star, points);
            double beyond = 0.0;
            for (int m = 0; m < n; ++m) {
                for (const double t : {-2.7, -0.8, 0.0, 0.5, 3.1}) {
                    const double y = t * star.f_y();
                    const Vector2d p = star.from_side(m, {star.border(m) + star.mu(y) - 1e-12, y});
                    const Series<3> a = before.expand(p, k + 1);
                    const Series<3> b = after.expand(p, k + 1);
                    for (int i = 0; i <= k; ++i) {
                        for (int j = 0; i + j <= k; ++j) {
                            EXPECT_LT((a.term(i, j) - b.term(i, j)).norm(), 1e-9);
                        }
                    }
                    beyond = std::max(beyond, (a.term(k + 1, 0) - b.term(k + 1, 0)).norm());
                }
            }
            EXPECT_GT(beyond, 1e-3) << "n = " << n << ", k = " << k;
        }
    }
}

}  // namespace
}  // namespace suture::manifold

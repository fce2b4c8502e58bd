#include "suture/fill/algebraic/member.h"

#include "suture/base/tolerance.h"
#include "suture/fill/algebraic/interpolate.h"
#include "suture/fill/algebraic/jet_space.h"
#include "suture/fill/algebraic/jets.h"
#include "suture/fill/algebraic/least_distance.h"

#include <Eigen/Geometry>

#include "kernel/core/algebraic/table_corner.h"
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace suture::algebraic {
namespace {

using Eigen::Vector3d;
using Eigen::VectorXd;

/// The table corner in doubles, its centre at the origin.
struct Corner {
    Partition partition;
    std::vector<Vector3d> rays;  ///< to the plane x + y + z = 0 of the paper
    Space space;
};

std::array<Polynomial<Rational>, 3> from_centre() {
    return {table::poly("x+1"), table::poly("y+1"), table::poly("z+1")};
}

Corner corner_of(const Partition& partition, int degree, int k = 1) {
    std::vector<Side<double>> sides;
    for (const Side<Rational>& side : table::sides(k)) {
        sides.push_back({rounded(substitute(side.f, from_centre())),
                         rounded(substitute(side.F, from_centre())), k});
    }
    std::vector<Polynomial<double>> planes;
    for (const auto& plane : table::planes(partition)) {
        planes.push_back(rounded(substitute(plane, from_centre())));
    }
    Corner corner{partition, {}, solve(make_system(partition, sides, planes, k, degree), 1e-11)};
    for (const auto& p : ray_points(partition, table::kCorners, table::kOuter)) {
        Vector3d ray;
        for (std::size_t c = 0; c < 3; ++c) {
            ray[static_cast<Eigen::Index>(c)] =
                Rational(p[c] - table::kCentre[c]).convert_to<double>();
        }
        corner.rays.push_back(ray * (-3.0 / ray.sum()));
    }
    return corner;
}

template <class Visit>
void for_each_ray(const Corner& corner, int divisions, const Visit& visit) {
    for (const Sector& sector : corner.partition.sectors) {
        for (int i = 0; i <= divisions; ++i) {
            for (int j = 0; i + j <= divisions; ++j) {
                const Vector3d b = Vector3d(i, j, divisions - i - j) / divisions;
                Vector3d ray = Vector3d::Zero();
                for (std::size_t c = 0; c < 3; ++c) {
                    ray += b[static_cast<Eigen::Index>(c)] *
                           corner.rays[static_cast<std::size_t>(sector.rays[c])];
                }
                visit(sector.cell, ray);
            }
        }
    }
}

std::vector<GuideSample> sphere_guide(const Corner& corner) {
    std::vector<GuideSample> guide;
    for_each_ray(corner, 24, [&](int cell, const Vector3d& ray) {
        guide.push_back({cell, ray.normalized(), ray.normalized()});
    });
    return guide;
}

std::vector<SheetCondition> tetrahedra(const Corner& corner, int split) {
    std::vector<SheetCondition> conditions;
    for (const Sector& sector : corner.partition.sectors) {
        Frustum frustum{Vector3d::Zero(), {}, 0.0, 1.0};
        for (int c = 0; c < 3; ++c) {
            frustum.directions.col(c) =
                corner.rays[static_cast<std::size_t>(sector.rays[static_cast<std::size_t>(c)])];
        }
        conditions.push_back({sector.cell, frustum, split});
    }
    return conditions;
}

std::vector<Polynomial<double>> cells_of(const Corner& corner, const VectorXd& x) {
    const VectorXd g = corner.space.basis * x;
    return split_cells(std::vector<double>(g.data(), g.data() + g.size()), corner.space.degree);
}

/// The first root on a ray, by scanning: the tests' own.
double distance_on(const Polynomial<double>& g, const Vector3d& ray) {
    const Vector3d u = ray.normalized();
    constexpr int kSteps = 400;
    double a = 0.5;
    for (int n = 0; n < kSteps; ++n) {
        const double b = 0.5 + (n + 1.0) / kSteps;
        if ((evaluate(g, a * u).value < 0.0) != (evaluate(g, b * u).value < 0.0)) {
            double lo = a;
            double hi = b;
            for (int step = 0; step < 60; ++step) {
                const double m = 0.5 * (lo + hi);
                ((evaluate(g, lo * u).value < 0.0) == (evaluate(g, m * u).value < 0.0) ? lo : hi) =
                    m;
            }
            return 0.5 * (lo + hi);
        }
        a = b;
    }
    return NAN;
}

struct Extent {
    double least = INFINITY, most = 0.0, diagonal = 0.0;
};
Extent extent_of(const Corner& corner, const std::vector<Polynomial<double>>& cells) {
    Extent extent;
    for_each_ray(corner, 24, [&](int cell, const Vector3d& ray) {
        const double r = distance_on(cells[static_cast<std::size_t>(cell)], ray);
        extent.least = std::min(extent.least, r);
        extent.most = std::max(extent.most, r);
    });
    extent.diagonal = distance_on(cells.back(), Vector3d(-1.0, -1.0, -1.0));
    return extent;
}

bool proven(const Corner& corner, const std::vector<Polynomial<double>>& cells, int split) {
    const auto conditions = tetrahedra(corner, split);
    return std::all_of(conditions.begin(), conditions.end(), [&](const SheetCondition& c) {
        return prove(cells[static_cast<std::size_t>(c.cell)], c.frustum, 1.0, 0.0, 0).single;
    });
}

/// The figures are an independent prototype's; they depend on how the guide is sampled.
constexpr double kShape = 3e-3;

TEST(Member, FollowsASphereWithCubicsInSevenCells) {
    const Corner corner = corner_of(with_inner_cells(3), 3);
    EXPECT_EQ(corner.space.rank, 54);
    const Member member(corner.space, sphere_guide(corner), {});
    const auto cells = cells_of(corner, member.best());
    const Extent extent = extent_of(corner, cells);
    EXPECT_NEAR(extent.least, 0.98514, kShape);
    EXPECT_NEAR(extent.most, 1.00965, kShape);
    EXPECT_NEAR(extent.diagonal, 0.99707, kShape);
    EXPECT_TRUE(proven(corner, cells, 2));  // single sheets without asking for them
}

/// The largest |g| on B-spline patches of one degree over a third of each sector, between a corner
/// and the centroid: the construction of the prototype below.
double largest_value_on_patches(const Corner& corner, const std::vector<Polynomial<double>>& cells,
                                int degree, int spans) {
    double most = 0.0;
    for (const Sector& sector : corner.partition.sectors) {
        const Polynomial<double>& g = cells[static_cast<std::size_t>(sector.cell)];
        for (std::size_t c = 0; c < 3; ++c) {
            const auto ray = [&](std::size_t k) {
                return corner.rays[static_cast<std::size_t>(sector.rays[(c + k) % 3])];
            };
            const Vector3d a = ray(0);
            const Vector3d b = 0.5 * (ray(0) + ray(1));
            const Vector3d d = 0.5 * (ray(0) + ray(2));
            const Vector3d m = (ray(0) + ray(1) + ray(2)) / 3.0;
            const SplineSurface surface = interpolate(
                [&](double u, double v) -> Vector3d {
                    const Vector3d on =
                        (1 - u) * (1 - v) * a + u * (1 - v) * b + u * v * m + (1 - u) * v * d;
                    return distance_on(g, on) * on.normalized();
                },
                degree, spans);
            const int steps = 3 * spans + 1;  // between the sites
            for (int i = 0; i <= steps; ++i) {
                for (int j = 0; j <= steps; ++j) {
                    const Vector3d p = evaluate(surface, static_cast<double>(i) / steps,
                                                static_cast<double>(j) / steps)
                                           .point;
                    most = std::max(most, std::abs(evaluate(g, p).value));
                }
            }
        }
    }
    return most;
}

TEST(Interpolate, ReachesTheCubicWithOrdersFourAndSix) {
    const Corner corner = corner_of(with_inner_cells(3), 3);
    const auto cells = cells_of(corner, Member(corner.space, sphere_guide(corner), {}).best());
    const auto errors = [&](int degree) {
        std::vector<double> result;
        for (const int spans : {2, 4, 8, 16}) {
            result.push_back(largest_value_on_patches(corner, cells, degree, spans));
        }
        return result;
    };
    // Of an independent prototype; its member and its samples differ a little.
    constexpr double kAlike = 2.0;
    const auto expect_like = [&](const std::vector<double>& found,
                                 const std::vector<double>& golden, int order) {
        for (std::size_t n = 0; n < golden.size(); ++n) {
            EXPECT_LT(found[n], kAlike * golden[n]) << n;
            EXPECT_GT(found[n], golden[n] / kAlike) << n;
        }
        EXPECT_NEAR(std::log2(found[2] / found[3]), order, 0.7);
    };
    expect_like(errors(3), {4.9e-4, 4.3e-5, 5.8e-6, 3.8e-7}, 4);
    expect_like(errors(5), {9.5e-6, 1.7e-6, 5.5e-8, 8.5e-10}, 6);
}

TEST(Member, NeedsConditionsForASingleSheetOfQuartics) {
    const Corner corner = corner_of(umbrella(3), 4);
    EXPECT_EQ(corner.space.rank, 77);
    EXPECT_EQ(corner.space.basis.cols(), 10);
    const Member member(corner.space, sphere_guide(corner), {});
    EXPECT_FALSE(proven(corner, cells_of(corner, member.best()), 3));
    const auto x = member.best_under(tetrahedra(corner, 3), 1.0, 1e-6, Progress{});
    ASSERT_TRUE(x);
    const auto cells = cells_of(corner, *x);
    EXPECT_TRUE(proven(corner, cells, 3));
    const Extent extent = extent_of(corner, cells);
    EXPECT_NEAR(extent.least, 0.98320, kShape);
    EXPECT_NEAR(extent.most, 1.00448, kShape);
    EXPECT_NEAR(extent.diagonal, 0.99445, kShape);
}

TEST(Member, JoinsTheNeighboursAndItselfExactly) {
    for (const int k : {0, 1, 2}) {
        SCOPED_TRACE(k);
        const Corner corner = corner_of(umbrella(3), k == 2 ? 5 : 4, k);
        ASSERT_GT(corner.space.basis.cols(), 0);
        const Member member(corner.space, sphere_guide(corner), {});
        const auto cells = cells_of(corner, member.best());
        for (std::size_t i = 0; i < 3; ++i) {
            const Polynomial<double> f = rounded(substitute(table::sides()[i].f, from_centre()));
            for (int n = 0; n <= 16; ++n) {
                const double angle = 0.5 * M_PI * n / 16;
                const Vector3d p = std::cos(angle) * corner.rays[i].normalized() +
                                   std::sin(angle) * corner.rays[(i + 1) % 3].normalized();
                const ValueAndGradient g = evaluate(cells[i], p);
                EXPECT_NEAR(g.value, 0.0, 1e-12);
                if (k > 0) {
                    const Vector3d normal = evaluate(f, p).gradient.normalized();
                    EXPECT_LT(g.gradient.cross(normal).norm(), 1e-11);
                }
            }
        }
    }
}

TEST(LeastDistance, FindsTheNearestPointOfAPolytope) {
    Eigen::MatrixXd G(3, 2);
    G << 1.0, 1.0, 1.0, 0.0, 0.0, 1.0;
    const auto x = least_distance(G, VectorXd{{2.0, 0.5, 1.2}}, Progress{});
    ASSERT_TRUE(x);
    EXPECT_NEAR((*x)[0], 0.8, 1e-10);
    EXPECT_NEAR((*x)[1], 1.2, 1e-10);
    G.row(2) << -1.0, -1.0;
    EXPECT_FALSE(least_distance(G, VectorXd{{2.0, 0.5, -1.0}}, Progress{}));
}

TEST(Frustum, ReproducesThePolynomialByDeCasteljau) {
    const Polynomial<double> p = rounded(table::poly("x^3 - 2xyz + 5y^2 - z + 4 + z^3"));
    Frustum frustum{Vector3d(0.3, -1.0, 2.0), {}, 0.5, 1.7};
    frustum.directions << 1.0, 0.2, 0.0, 0.1, 1.4, -0.3, -0.2, 0.5, 0.9;
    const VectorXd c = bernstein_map(frustum, 3) * coefficients(p);
    const double tau = 0.3;
    const Vector3d b(0.2, 0.5, 0.3);
    double sum = 0.0;
    const auto all = monomials(3);
    const double in_t[] = {0.343, 3 * 0.49 * 0.3, 3 * 0.7 * 0.09, 0.027};
    for (int m = 0; m < 4; ++m) {
        for (int r = 0; r < layer_size(3); ++r) {
            const Monomial& e = all[static_cast<std::size_t>(monomial_count(2) + r)];
            const double weight =
                6.0 / (std::tgamma(e.i + 1) * std::tgamma(e.j + 1) * std::tgamma(e.k + 1));
            sum += c[m * layer_size(3) + r] * in_t[m] * weight * std::pow(b[0], e.i) *
                   std::pow(b[1], e.j) * std::pow(b[2], e.k);
        }
    }
    const double t = 0.5 + tau * 1.2;
    EXPECT_NEAR(sum, evaluate(p, frustum.centre + t * (frustum.directions * b)).value, 1e-11);
}

/// The jets of a paper's side on its arc from one corner to the next, centre at the origin.
std::vector<SideJets> table_jets() {
    std::vector<SideJets> sides;
    std::vector<Side<Rational>> exact = table::sides(1);
    for (std::size_t i = 0; i < exact.size(); ++i) {
        const auto f = rounded(substitute(exact[i].f, from_centre()));
        const auto corner = [&](std::size_t c) {
            Vector3d p;
            for (std::size_t x = 0; x < 3; ++x) {
                p[static_cast<Eigen::Index>(x)] =
                    Rational(table::kCorners[c % 3][x] - table::kCentre[x]).convert_to<double>();
            }
            return p;
        };
        const Vector3d a = corner(i);
        const Vector3d b = corner(i + 1);
        SideJets side;
        constexpr int kJets = 33;
        for (int n = 0; n < kJets; ++n) {
            // A quarter of the unit circle about the centre.
            const double t = 0.5 * kPi * n / (kJets - 1);
            SideJet jet;
            jet.point = std::cos(t) * a + std::sin(t) * b;
            const Vector3d tangent = std::cos(t) * b - std::sin(t) * a;
            jet.normal = evaluate(f, jet.point).gradient.normalized();
            jet.inward = jet.normal.cross(tangent).normalized();
            jet.curvature.setZero();
            side.jets.push_back(jet);
        }
        sides.push_back(side);
    }
    return sides;
}

TEST(JetSpace, HasAsManyMembersAsTheExactSystemOfTheTableCorner) {
    // Theorem 2.2: jets and g = gamma f + beta F^2 ask for the same.
    const struct {
        bool inner;
        int degree, members;
    } cases[] = {{false, 3, 1}, {false, 4, 10}, {true, 3, 6}};
    for (const auto& c : cases) {
        SCOPED_TRACE(c.degree);
        const Partition partition = c.inner ? with_inner_cells(3) : umbrella(3);
        std::vector<Polynomial<double>> planes;
        for (const auto& plane : table::planes(partition)) {
            planes.push_back(rounded(substitute(plane, from_centre())));
        }
        const JetSpace jets(partition, table_jets(), planes, 1, c.degree);
        EXPECT_EQ(jets.within(1e-11).dimension, c.members);
        EXPECT_EQ(jets.within(1e-8).dimension, c.members);
        EXPECT_EQ(corner_of(partition, c.degree).space.basis.cols(), c.members);
    }
}

}  // namespace
}  // namespace suture::algebraic

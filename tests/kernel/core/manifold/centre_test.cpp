#include "suture/fill/manifold/centre.h"

#include "suture/base/tolerance.h"
#include "suture/fill/manifold/layout.h"

#include <Eigen/Geometry>

#include "kernel/core/manifold/support.h"

#include <algorithm>

namespace suture::manifold {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using test::make_star;
using test::rough_points;
using test::uneven;

/// Control points over their charts on a smooth sheet.
Eigen::Matrix3Xd smooth_points(const Star& star) {
    Eigen::Matrix3Xd points(3, star.count());
    for (int m = 0; m < star.n(); ++m) {
        for (int i = 0; i < star.charts_x(); ++i) {
            for (int j = 0; j < star.charts_y(m); ++j) {
                const Vector2d c = star.chart_centre(m, i, j);
                points.col(star.point_of(m, i, j)) =
                    Vector3d(c.x(), c.y(), std::sin(0.3 * c.x()) * std::cos(0.2 * c.y()));
            }
        }
    }
    return points;
}

double diameter(const Eigen::Matrix3Xd& points) {
    return (points.rowwise().maxCoeff() - points.rowwise().minCoeff()).norm();
}

Vector3d normal_of(const SurfaceJet& jet) {
    return jet.u.cross(jet.v).normalized();
}

/// How two faces meet at a point.
struct Meeting {
    double gap = 0.0;
    double angle = 0.0;

    void add(const SurfaceJet& a, const SurfaceJet& b) {
        gap = std::max(gap, (a.point - b.point).norm());
        angle = std::max(angle, std::atan2(normal_of(a).cross(normal_of(b)).norm(),
                                           normal_of(a).dot(normal_of(b))));
    }
};

constexpr int kPlaces = 97;

Meeting between_quads(const Star& star, const Centre& centre) {
    Meeting meeting;
    const int n = star.n();
    for (int m = 0; m < n; ++m) {
        for (int i = 0; i <= kPlaces; ++i) {
            const double t = static_cast<double>(i) / kPlaces;
            meeting.add(evaluate(centre.quads[static_cast<std::size_t>(m)], t, 0.0),
                        evaluate(centre.quads[static_cast<std::size_t>((m + n - 1) % n)], 0.0, t));
        }
    }
    return meeting;
}

Meeting with_strips(const StarSurface& surface, const Centre& centre) {
    const Star& star = surface.star();
    const double reach = QuadMap(star).reach();
    Meeting meeting;
    const int n = star.n();
    for (int m = 0; m < n; ++m) {
        const SplineSurface strip = border_spline(surface, m);
        for (int i = 0; i <= kPlaces; ++i) {
            const double t = static_cast<double>(i) / kPlaces;
            meeting.add(evaluate(centre.quads[static_cast<std::size_t>(m)], 1.0, t),
                        evaluate(strip, star.inner(), reach * t));
            meeting.add(evaluate(centre.quads[static_cast<std::size_t>((m + n - 1) % n)], t, 1.0),
                        evaluate(strip, star.inner(), -reach * t));
        }
    }
    return meeting;
}

TEST(ManifoldCentre, LaysQuadsIntoXWithoutFolds) {
    for (const int n : {3, 4, 5, 6, 7, 9}) {
        for (int k = 0; k <= 4; ++k) {
            const QuadMap map(make_star(uneven(k, n)));
            double least = INFINITY;
            double most = 0.0;
            constexpr int kGrid = 24;
            for (int a = 0; a < kGrid; ++a) {
                for (int b = 0; b < kGrid; ++b) {
                    const Vector2d at((a + 0.5) / kGrid, (b + 0.5) / kGrid);
                    const PlaneSeries p = map.expand(1, at, {1.0, 1.0}, 1);
                    const double area = p[0].term(1, 0)[0] * p[1].term(0, 1)[0] -
                                        p[0].term(0, 1)[0] * p[1].term(1, 0)[0];
                    least = std::min(least, area);
                    most = std::max(most, area);
                }
            }
            EXPECT_GT(least, 0.3 * most) << "n = " << n << ", k = " << k;
        }
    }
}

TEST(ManifoldCentre, MeetsStripsAndQuadsSmoothlyHoweverRoughTheNet) {
    for (const int n : {3, 5, 6, 7}) {
        for (int k = 1; k <= 4; ++k) {
            const Star star = make_star(uneven(k, n));
            const StarSurface surface(star, rough_points(star));
            const Centre centre = fit_centre(surface, 0.0, 8);
            const double size = diameter(surface.points());
            const Meeting strips = with_strips(surface, centre);
            EXPECT_LT(strips.gap, 1e-11 * size) << "n = " << n << ", k = " << k;
            EXPECT_LT(degrees(strips.angle), 1e-8) << "n = " << n << ", k = " << k;
            const Meeting quads = between_quads(star, centre);
            EXPECT_LT(quads.gap, 1e-11 * size) << "n = " << n << ", k = " << k;
            EXPECT_LT(degrees(quads.angle), 1e-8) << "n = " << n << ", k = " << k;
        }
    }
}

TEST(ManifoldCentre, FitsAMillionthOfTheDiameter) {
    for (const int n : {3, 5}) {
        for (int k = 2; k <= 4; ++k) {
            const Star star = make_star(uneven(k, n));
            const StarSurface surface(star, smooth_points(star));
            const double size = diameter(surface.points());
            const Centre centre = fit_centre(surface, 1e-6 * size, 64);
            EXPECT_LT(centre.error, 1e-6 * size) << "n = " << n << ", k = " << k;
            // Measured again, elsewhere.
            const QuadMap map(star);
            double error = 0.0;
            for (int a = 0; a <= kPlaces; ++a) {
                const Vector2d at(a / (kPlaces + 0.1), std::fmod(0.618 * a, 1.0));
                const Vector3d p = evaluate(centre.quads[0], at.x(), at.y()).point;
                error = std::max(error, (p - surface.at(map.at(0, at))).norm());
            }
            EXPECT_LT(error, 1.5e-6 * size) << "n = " << n << ", k = " << k;
        }
    }
}

TEST(ManifoldCentre, GetsBetterWithMoreSpansAsOrderKAllows) {
    for (int k = 1; k <= 3; ++k) {
        const Star star = make_star(uneven(k, 5));
        const StarSurface surface(star, smooth_points(star));
        const Centre coarse = fit_centre(surface, 0.0, 8);
        const Centre fine = fit_centre(surface, 0.0, 32);
        const double ratio = static_cast<double>(fine.spans) / coarse.spans;
        EXPECT_LT(fine.error, coarse.error * std::pow(ratio, -0.8 * (k + 1))) << "k = " << k;
    }
}

TEST(ManifoldLayout, GivesEveryInnerEdgeTheSamePointsOnBothSides) {
    for (const int n : {3, 5}) {
        const Star star = make_star(uneven(2, n));
        const StarSurface surface(star, rough_points(star));
        const FillResult result =
            lay_out(surface, quads_of(surface, fit_centre(surface, 0.0, 8)), {});
        EXPECT_EQ(static_cast<int>(result.patches.size()), 2 * n);
        std::vector<std::vector<std::pair<const Patch*, const EdgeUse*>>> uses(
            result.inner_edges.size());
        for (const Patch& patch : result.patches) {
            for (const EdgeUse& use : patch.wires.front()) {
                uses[static_cast<std::size_t>(use.index)].emplace_back(&patch, &use);
            }
        }
        int single = 0;
        for (std::size_t e = 0; e < uses.size(); ++e) {
            single += uses[e].size() == 1 ? 1 : 0;
            ASSERT_TRUE(uses[e].size() == 1 || uses[e].size() == 2);
            for (int i = 0; i <= 10; ++i) {
                const auto at = [&](std::size_t which) {
                    const Vector2d uv = uses[e][which].second->at(i / 10.0);
                    return evaluate(uses[e][which].first->surface, uv.x(), uv.y()).point;
                };
                if (uses[e].size() == 2) {
                    EXPECT_NE(uses[e][0].second->backwards, uses[e][1].second->backwards);
                    EXPECT_LT((at(0) - at(1)).norm(), 1e-10) << "edge " << e;
                }
                const Node& node = i == 0 ? result.inner_edges[e].from : result.inner_edges[e].to;
                if (i == 0 || i == 10) {
                    const Vector3d vertex =
                        result.inner_vertices[static_cast<std::size_t>(node.index)];
                    EXPECT_LT((at(0) - vertex).norm(), 1e-10) << "edge " << e;
                }
            }
        }
        EXPECT_EQ(single, n);
    }
}

/// The border zone as a face is the surface itself.
TEST(ManifoldLayout, KeepsTheBorderZoneExactly) {
    for (int k = 0; k <= 4; ++k) {
        const Star star = make_star(uneven(k, 5));
        const StarSurface surface(star, rough_points(star));
        const double size = diameter(surface.points());
        for (int m = 0; m < star.n(); ++m) {
            const SplineSurface strip = border_spline(surface, m);
            for (int i = 0; i <= kPlaces; ++i) {
                const double y = lower_end(star, m) + (upper_end(star, m) - lower_end(star, m)) *
                                                          (i + 1e-9) / (kPlaces + 2e-9);
                const double x = star.inner() +
                                 (star.border(m) - star.inner()) * std::fmod(0.618 * i + 1e-9, 1.0);
                const Vector3d p = surface.at(star.from_side(m, {x + star.mu(y), y}));
                EXPECT_LT((p - evaluate(strip, x, y).point).norm(), 1e-11 * size);
            }
        }
    }
}

}  // namespace
}  // namespace suture::manifold

#include "suture/fill/manifold/spacing.h"

#include "suture/fill/manifold/fold.h"

#include "kernel/core/manifold/support.h"

#include <algorithm>

namespace suture::manifold {
namespace {

using test::make_star;

/// The place of a joint on a side in its range of y, as spacing_for() and the border have it.
double y_of(const Star& star, int m, double share, double centre) {
    const double t = 2.0 * share - 1.0;
    const double high = star.f_y() + std::sin(star.alpha()) * star.border(m + 1);
    return high * (t - centre * (1.0 - t * t) / (1.0 - centre * centre));
}

TEST(ManifoldSpacing, IsEvenWhereNothingJoins) {
    const Spacing spacing = spacing_for(2, 9, 0.0, {{}, {}, {}, {}, {}}, 3);
    EXPECT_TRUE(spacing.size.given.empty());
    EXPECT_EQ(spacing.size.layers, 9);
    EXPECT_EQ(make_star(spacing.size).aperture(), 1.0);
}

TEST(ManifoldSpacing, PutsKnotsAtJointsAndCloseToThem) {
    const std::vector<std::vector<double>> joints = {
        {0.217, 0.386, 0.614, 0.783}, {}, {0.5}, {0.07}, {0.46, 0.9}};
    for (const int k : {0, 1, 2, 3, 4}) {
        const Spacing spacing = spacing_for(k, 14, 0.0, joints, 3);
        const Star star = make_star(spacing.size);
        for (int m = 0; m < star.n(); ++m) {
            const auto side = static_cast<std::size_t>(m);
            EXPECT_EQ(star.border(m), star.border(0)) << "k = " << k;
            EXPECT_EQ(spacing.size.given[side].depth.size(), spacing.size.given[0].depth.size());
            for (const double share : joints[side]) {
                const double y = y_of(star, m, share, spacing.centres[side]);
                std::vector<double> distances;
                for (const double knot : star.knots_y(m)) {
                    distances.push_back(std::abs(knot - y));
                }
                std::sort(distances.begin(), distances.end());
                EXPECT_LT(distances[0], 0.05) << "k = " << k << ", joint at " << share;
                EXPECT_LT(distances[2], 0.3) << "k = " << k << ", joint at " << share;
            }
        }
    }
}

TEST(ManifoldSpacing, MovesAJointNearTheMiddleThere) {
    const Spacing spacing = spacing_for(2, 10, 0.0, {{0.46}, {}, {}, {0.8}}, 3);
    EXPECT_NEAR(spacing.centres[0], -0.08, 1e-12);
    EXPECT_EQ(spacing.centres[3], 0.0);
    const Star star = make_star(spacing.size);
    EXPECT_NEAR(y_of(star, 0, 0.46, spacing.centres[0]), 0.0, 1e-12);
}

TEST(ManifoldFold, IsFoundWhereTheNetIsTurnedOver) {
    for (const int n : {3, 5}) {
        const Star star = make_star(test::uneven(2, n, 3));
        Eigen::Matrix3Xd points(3, star.count());
        for (int m = 0; m < n; ++m) {
            for (int i = 0; i < star.charts_x(); ++i) {
                for (int j = 0; j < star.charts_y(m); ++j) {
                    const Eigen::Vector2d c = star.chart_centre(m, i, j);
                    points.col(star.point_of(m, i, j)) << c, 0.3 * std::sin(c.x());
                }
            }
        }
        EXPECT_FALSE(find_fold(StarSurface(star, points)));
        // In the strip of side 1, and in the middle.
        for (const int i : {star.charts_x() - 3, 1}) {
            Eigen::Matrix3Xd folded = points;
            for (int j = star.layers() - 2; j <= star.layers() + 2; ++j) {
                folded.col(star.point_of(1, i, j)) = 5.0 * points.col(star.point_of(1, i + 2, j)) -
                                                     4.0 * points.col(star.point_of(1, i, j));
            }
            const auto fold = find_fold(StarSurface(star, folded));
            ASSERT_TRUE(fold) << "n = " << n << ", i = " << i;
            EXPECT_GT(fold->angle, M_PI / 2.0);
        }
    }
}

}  // namespace
}  // namespace suture::manifold

#include "kernel/core/manifold/support.h"

#include <map>
#include <set>

namespace suture::manifold {
namespace {

using test::make_star;
using test::uneven;

TEST(ManifoldStar, HasNHSquaredControlPointsWithTwoCharts) {
    for (int k = 0; k <= 4; ++k) {
        for (const int n : {3, 4, 5, 6, 7}) {
            const Star star = make_star(uneven(k, n));
            int twice = 0;
            for (int point = 0; point < star.count(); ++point) {
                ASSERT_TRUE(star.weight(point) == 1.0 || star.weight(point) == 0.5)
                    << star.weight(point);
                twice += star.weight(point) == 0.5 ? 1 : 0;
            }
            EXPECT_EQ(twice, n * star.h() * star.h()) << "k = " << k << ", n = " << n;
        }
    }
}

TEST(ManifoldStar, NumbersEveryControlPoint) {
    const int expected[] = {30, 75, 150, 240};
    for (int k = 0; k <= 3; ++k) {
        const Star star = make_star({k, Star::least_layers(k, 5), {2, 2, 2, 2, 2}, 0.5, {}});
        EXPECT_EQ(star.count(), expected[k]);
        std::set<int> seen;
        for (int m = 0; m < 5; ++m) {
            for (int i = 0; i < star.charts_x(); ++i) {
                for (int j = 0; j < star.charts_y(m); ++j) {
                    seen.insert(star.point_of(m, i, j));
                }
            }
        }
        EXPECT_EQ(static_cast<int>(seen.size()), star.count());
    }
}

TEST(ManifoldStar, SharesPointsThatLieInTheSamePlace) {
    for (int k = 0; k <= 3; ++k) {
        const Star star = make_star(uneven(k, 5));
        std::map<int, Eigen::Vector2d> places;
        for (int m = 0; m < 5; ++m) {
            for (int i = 0; i < star.charts_x(); ++i) {
                for (int j = 0; j < star.charts_y(m); ++j) {
                    const Eigen::Vector2d place = star.chart_centre(m, i, j);
                    const auto [it, added] = places.try_emplace(star.point_of(m, i, j), place);
                    ASSERT_LT((it->second - place).norm(), 1e-12) << k << m << i << j;
                }
            }
        }
    }
}

TEST(ManifoldStar, HasTheMuOfThePaper) {
    for (const int n : {3, 5, 6}) {
        for (int k = 0; k <= 3; ++k) {
            const Star star = make_star(uneven(k, n));
            const double fy = star.f_y();
            const double cot = 1.0 / std::tan(star.alpha());
            for (const double t : {-0.9, -0.3, 0.0, 0.45, 0.8}) {
                const double t2 = t * t;
                const double q[] = {0.0, (t2 - 1.0) / 2.0, (-t2 * t2 + 6.0 * t2 - 5.0) / 8.0,
                                    (t2 * t2 * t2 - 5.0 * t2 * t2 + 15.0 * t2 - 11.0) / 16.0};
                EXPECT_NEAR(star.mu(t * fy), star.f_x() + fy * cot * q[k], 1e-14);
                EXPECT_NEAR(star.mu_series(t * fy, t * fy, 3)[0], star.mu(t * fy), 1e-14);
            }
        }
    }
}

TEST(ManifoldStar, JoinsThePiecesOfMuWithOrderKAndNoMore) {
    for (int k = 0; k <= 4; ++k) {
        const Star star = make_star(uneven(k, 5));
        const double fy = star.f_y();
        const Eigen::VectorXd inside = star.mu_series(fy, 0.99 * fy, k + 1);
        const Eigen::VectorXd outside = star.mu_series(fy, 1.01 * fy, k + 1);
        EXPECT_LT((inside - outside).head(k + 1).cwiseAbs().maxCoeff(), 1e-11) << k;
        EXPECT_GT(std::abs(inside[k + 1] - outside[k + 1]), 1e-2) << k;
    }
}

TEST(ManifoldStar, RefusesWhatIsNoPatch) {
    const auto said = [](const StarSize& size) {
        const auto star = Star::make(size);
        return star ? std::string() : star.error().message;
    };
    EXPECT_NE(said({2, 6, {1, 1}, 0.5, {}}).find("3 sides"), std::string::npos);
    EXPECT_NE(said({-1, 6, {1, 1, 1}, 0.5, {}}).find("-1"), std::string::npos);
    EXPECT_NE(said({2, 6, {1, 0, 1}, 0.5, {}}).find("side 1"), std::string::npos);
    EXPECT_NE(said({2, 5, {1, 1, 1}, 0.5, {}}).find("needs 6"), std::string::npos);
    EXPECT_NE(said({2, 3, {1, 1, 1, 1, 1}, 0.5, {}}).find("needs 4"), std::string::npos);
    const double bound = Star::aperture_bound(2, 5);
    EXPECT_NEAR(bound, 2.0 / (2.0 * std::cos(M_PI / 5.0)), 1e-15);
    EXPECT_NE(said({2, 4, {1, 1, 1, 1, 1}, bound, {}}).find("aperture"), std::string::npos);
    EXPECT_NE(said({2, 4, {1, 1, 1, 1, 1}, -0.1, {}}).find("aperture"), std::string::npos);
    EXPECT_EQ(said({2, 4, {1, 1, 1, 1, 1}, 0.999 * bound, {}}), "");
    StarSize given = uneven(2, 3);
    given.given.resize(3);
    given.given[1].depth = {0, 1, 2, 2, 3, 4, 5};
    EXPECT_NE(said(given).find("side 1"), std::string::npos);
}

}  // namespace
}  // namespace suture::manifold

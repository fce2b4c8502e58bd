#pragma once

#include "suture/fill/manifold/surface.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

/// What the tests of the manifold patch share.
namespace suture::manifold::test {

inline Star make_star(const StarSize& size) {
    auto star = Star::make(size);
    EXPECT_TRUE(star) << star.error().message;
    return *star;
}

/// Sides of different lengths, aperture well inside its bound.
inline StarSize uneven(int k, int n, int more_layers = 1) {
    StarSize size;
    size.k = k;
    size.layers = Star::least_layers(k, n) + more_layers;
    for (int m = 0; m < n; ++m) {
        size.columns.push_back(1 + (2 * m) % 3);
    }
    size.aperture = 0.7 * Star::aperture_bound(k, n);
    return size;
}

/// Control points over their charts, out of the plane and a little off their place.
inline Eigen::Matrix3Xd rough_points(const Star& star, unsigned seed = 7) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> noise(-0.4, 0.4);
    Eigen::Matrix3Xd points(3, star.count());
    for (int m = 0; m < star.n(); ++m) {
        for (int i = 0; i < star.charts_x(); ++i) {
            for (int j = 0; j < star.charts_y(m); ++j) {
                const Eigen::Vector2d c = star.chart_centre(m, i, j);
                points.col(star.point_of(m, i, j)) =
                    Eigen::Vector3d(c.x() + noise(random), c.y() + noise(random),
                                    std::sin(0.5 * c.x()) + noise(random));
            }
        }
    }
    return points;
}

/// Points of X all over the patch, inside its border.
inline std::vector<Eigen::Vector2d> inside(const Star& star, int count, unsigned seed = 3) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    std::vector<Eigen::Vector2d> points;
    double reach = 0.0;
    for (int m = 0; m < star.n(); ++m) {
        reach = std::max(reach, 2.0 * (star.border(m) + star.aperture()));
    }
    while (static_cast<int>(points.size()) < count) {
        const double r = reach * std::pow(unit(random), 1.5);
        const double a = 2.0 * M_PI * unit(random);
        const Eigen::Vector2d p(r * std::cos(a), r * std::sin(a));
        bool in = true;
        for (int m = 0; m < star.n(); ++m) {
            const Eigen::Vector2d q = star.to_side(m, p);
            const bool beside = q.x() > 0.0 || star.n() == 3;
            in = in && (!beside || q.x() - star.mu(q.y()) < star.border(m));
        }
        if (in) {
            points.push_back(p);
        }
    }
    return points;
}

}  // namespace suture::manifold::test

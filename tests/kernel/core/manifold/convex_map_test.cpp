#include "suture/fill/manifold/convex_map.h"

#include <gtest/gtest.h>

#include <cmath>

namespace suture::manifold {
namespace {

using Eigen::Vector2d;

/// A polygon's border in small segments, the images spread over a circle by length.
struct Outline {
    std::vector<Vector2d> boundary, images;
};

Outline outline_of(const std::vector<Vector2d>& corners, int segments) {
    Outline outline;
    double length = 0.0;
    std::vector<double> along;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Vector2d& a = corners[i];
        const Vector2d& b = corners[(i + 1) % corners.size()];
        for (int k = 0; k < segments; ++k) {
            outline.boundary.emplace_back(a + (b - a) * k / segments);
            along.push_back(length + (b - a).norm() * k / segments);
        }
        length += (b - a).norm();
    }
    for (const double at : along) {
        const double angle = 2.0 * M_PI * at / length;
        outline.images.emplace_back(std::cos(angle), std::sin(angle));
    }
    return outline;
}

TEST(ConvexMap, IsLinearWhereItsBorderIs) {
    Outline outline = outline_of({{0.0, 0.0}, {3.0, 0.0}, {3.0, 1.0}, {0.0, 1.0}}, 60);
    outline.images = outline.boundary;
    const auto map = ConvexMap::make(outline.boundary, outline.images);
    ASSERT_TRUE(map) << map.error().message;
    for (const Vector2d& p : {Vector2d(0.3, 0.4), Vector2d(1.7, 0.2), Vector2d(2.6, 0.7)}) {
        EXPECT_LT((map->at(p) - p).norm(), 1e-3);
    }
}

/// A bent strip, whose arms a map from the convex side by least squares would fold.
TEST(ConvexMap, TakesABentStripThereAndBackWithoutAFold) {
    for (const double size : {1e-3, 1.0, 1e3}) {
        std::vector<Vector2d> corners = {{0, 0}, {6, 0}, {6, 4}, {5, 4},
                                         {5, 1}, {1, 1}, {1, 4}, {0, 4}};
        for (Vector2d& corner : corners) {
            corner *= size;
        }
        const Outline outline = outline_of(corners, 40);
        const auto map = ConvexMap::make(outline.boundary, outline.images);
        ASSERT_TRUE(map) << map.error().message;
        for (const Vector2d& p : {Vector2d(0.5, 3.3), Vector2d(0.4, 0.6), Vector2d(2.7, 0.5),
                                  Vector2d(5.6, 0.4), Vector2d(5.5, 3.1)}) {
            const Vector2d from = size * p;
            const auto back = map->inverse(map->at(from));
            ASSERT_TRUE(back);
            EXPECT_LT((*back - from).norm(), 1e-8 * size);
            constexpr double kStep = 1e-5;
            const Vector2d x = map->at(from + Vector2d(kStep * size, 0.0)) - map->at(from);
            const Vector2d y = map->at(from + Vector2d(0.0, kStep * size)) - map->at(from);
            EXPECT_GT(x.x() * y.y() - x.y() * y.x(), 0.0);
        }
    }
}

}  // namespace
}  // namespace suture::manifold

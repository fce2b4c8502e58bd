#include "suture/fill/recognise/surface_foot.h"

#include <gtest/gtest.h>

#include <cmath>

namespace suture::recognise {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

/// (v² + 0.02 v, u, 0): beyond v = 0 it goes on by 0.02, turns, and comes back over itself.
SplineSurface turning_back() {
    SplineSurface surface;
    surface.degree_u = 1;
    surface.degree_v = 2;
    surface.knots_u = {0.0, 0.0, 1.0, 1.0};
    surface.knots_v = {0.0, 0.0, 0.0, 1.0, 1.0, 1.0};
    surface.poles = Eigen::Matrix3Xd::Zero(3, 6);
    surface.poles.row(0) << 0.0, 0.0, 0.01, 0.01, 1.02, 1.02;
    surface.poles.row(1) << 0.0, 1.0, 0.0, 1.0, 0.0, 1.0;
    return surface;
}

TEST(SurfaceFoot, StaysInsideWhereItsContinuationTurnsBack) {
    const SurfaceFoot foot(turning_back());
    for (int k = 0; k <= 200; ++k) {
        const double v = 1e-6 * std::pow(1e6, k / 200.0);
        const Vector2d uv = foot.find({v * v + 0.02 * v, 0.4, 1e-5});
        EXPECT_NEAR(uv.x(), 0.4, 1e-9);
        EXPECT_NEAR(uv.y(), v, 1e-7) << v;
    }
}

/// Its cubic begins with a bend so sharp that full steps lead from the grid's nearest point out of
/// the domain and back.
TEST(SurfaceFoot, IsThePointItselfBesideASharpBend) {
    SplineSurface surface;
    surface.degree_u = 1;
    surface.degree_v = 3;
    surface.knots_u = {0.0, 0.0, 1.0, 1.0};
    surface.knots_v = {0.0, 0.0, 0.0, 0.0, 1.0, 1.0, 1.0, 1.0};
    surface.poles = Eigen::Matrix3Xd::Zero(3, 8);
    surface.poles.row(0) << 0.1989, 0.1989, 0.1846, 0.1846, 0.5611, 0.5611, 0.9552, 0.9552;
    surface.poles.row(1) << 0.0, 1.0, 0.0, 1.0, 0.0, 1.0, 0.0, 1.0;
    surface.poles.row(2) << 0.1730, 0.1730, 0.1996, 0.1996, -0.0414, -0.0414, 0.0679, 0.0679;
    const SurfaceFoot foot(surface);
    for (const double v : {0.0, 0.02, 0.045, 0.05, 0.055, 0.06, 0.5, 1.0}) {
        const Vector3d point = evaluate(surface, 0.4, v).point;
        const Vector2d uv = foot.find(point);
        EXPECT_LT((evaluate(surface, uv.x(), uv.y()).point - point).norm(), 1e-9) << v;
    }
}

TEST(SurfaceFoot, GoesOnBeyondABorderWhereThePointDoes) {
    const SurfaceFoot foot(turning_back());
    for (const double v : {-1e-3, -5e-3, 1.02}) {
        const Vector2d uv = foot.find({v * v + 0.02 * v, 1.1, 0.0});
        EXPECT_NEAR(uv.x(), 1.1, 1e-9);
        EXPECT_NEAR(uv.y(), v, 1e-7);
    }
}

}  // namespace
}  // namespace suture::recognise

#include "suture/fill/recognise/ball.h"

#include "support/windows.h"
#include "suture/fill/recognise/form.h"
#include "suture/fill/recognise/surface_foot.h"

#include <gtest/gtest.h>

namespace suture::recognise {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

/// A side along a line of the domain of a closed form.
Ribbon side_on(const Surface& surface, bool reversed, const Vector2d& from, const Vector2d& to,
               int number) {
    Ribbon ribbon;
    ribbon.edge = ribbon.face = number;
    const auto uv = [from, to](double s) -> Vector2d { return from + s * (to - from); };
    ribbon.support = Support{surface, reversed, uv};
    ribbon.at = [surface, reversed, uv, d = Vector2d(to - from)](double s) {
        const SurfaceJet jet = evaluate(surface, uv(s).x(), uv(s).y());
        RibbonPoint p;
        p.point = jet.point;
        p.normal = (reversed ? -1.0 : 1.0) * jet.u.cross(jet.v).normalized();
        p.tangent = jet.u * d.x() + jet.v * d.y();
        p.inward = p.normal.cross(p.tangent).normalized();
        p.curvature.setZero();
        return p;
    };
    return ribbon;
}

Hole hole_between(const Ribbon& a, const Ribbon& b) {
    Hole hole;
    hole.loops.push_back({{a, b}});
    hole.diameter = windows::diameter_of(hole);
    return hole;
}

/// Fillet at the foot of a post: a torus.
struct Post {
    double a, r;
    Hole hole;

    Post(double a_, double r_, double scale) : a(a_ * scale), r(r_ * scale) {
        const Frame frame = windows::tilted(scale);
        const Plane floor{frame};
        const Cylinder post{frame, a};
        // Contacts: on the floor at radius a + r, on the post at height r; both in steps of angle.
        const Ribbon on_post = side_on(post, false, {2.0, r}, {0.3, r}, 2);
        Ribbon on_floor;
        on_floor.edge = on_floor.face = 1;
        const double rho = a + r;
        const auto uv = [rho](double s) -> Vector2d {
            const double u = 0.3 + 1.7 * s;
            return {rho * std::cos(u), rho * std::sin(u)};
        };
        on_floor.support = Support{floor, false, uv};
        on_floor.at = [floor, uv, rho](double s) {
            const SurfaceJet jet = evaluate(Surface(floor), uv(s).x(), uv(s).y());
            RibbonPoint p;
            p.point = jet.point;
            p.normal = floor.frame.z;
            p.tangent = 1.7 * (-uv(s).y() * floor.frame.x + uv(s).x() * floor.frame.y);
            p.inward = p.normal.cross(p.tangent).normalized();
            p.curvature.setZero();
            return p;
        };
        hole = hole_between(on_floor, on_post);
    }
    [[nodiscard]] Surface truth(double scale) const {
        Frame frame = windows::tilted(scale);
        frame.origin += r * frame.z;
        return Torus{frame, a + r, r};
    }
};

TEST(RollingBall, EnvelopsTheTorusAtTheFootOfAPost) {
    for (const double scale : {1e-3, 1.0, 1e3}) {
        const Post post(4.0, 1.5, scale);
        const Border border = border_of(post.hole);
        const auto guesses = guess_balls(border);
        ASSERT_FALSE(guesses.empty());
        // Concave: the ball lies outside of the material.
        EXPECT_NEAR(guesses.front().radius, -post.r, 1e-9 * post.r);
        const auto arcs = ball_surface(guesses.front(), -post.r, border, 1e-9 * post.hole.diameter);
        ASSERT_TRUE(arcs) << arcs.error().message;
        EXPECT_LT(arcs->error, 1e-9 * post.hole.diameter);
        const Surface torus = post.truth(scale);
        const SplineSurface& s = arcs->surface;
        double off = 0.0;
        for (int i = 0; i <= 20; ++i) {
            for (int j = 0; j <= 10; ++j) {
                const double u = s.knots_u.back() * i / 20.0;
                off = std::max(off,
                               std::abs(distance_to(torus, evaluate(s, u, j / 10.0).point).value));
            }
        }
        EXPECT_LT(off, 1e-8 * post.hole.diameter);
        const SurfaceFoot foot(s);
        EXPECT_LT(measure([&](const Vector3d& p) { return foot.foot(p); }, border).gap, 1e-8);
    }
}

// The centre of a ball that touches two cylinders from outside is a + r from one axis and b + r
// from the other.
TEST(RollingBall, TouchesTwoCrossingCylinders) {
    const double a = 5.0;
    const double b = 3.0;
    const double r = 1.2;
    const Cylinder one{Frame(), a};
    Frame across;
    across.z = Vector3d(1.0, 0.2, 0.0).normalized();
    across.x = Vector3d::UnitZ();
    across.y = across.z.cross(across.x);
    const Cylinder two{across, b};
    const Support first{one, false, {}};
    const Support second{two, false, {}};
    const RollingBall ball(first, second, -r);
    const auto start = ball.near({0.4, 3.5}, {0.6, 5.5});
    ASSERT_TRUE(start);
    // As far as the first quarter of the path reaches.
    const Eigen::Matrix3Xd cover =
        (Eigen::Matrix3Xd(3, 2) << start->centre, start->centre + 0.8 * start->tangent).finished();
    const auto path = walk(ball, *start, 0.1, cover);
    ASSERT_TRUE(path) << path.error().message;
    const auto arcs = fit_arcs(ball, *path, 1e-9);
    ASSERT_TRUE(arcs) << arcs.error().message;
    const SplineSurface& s = arcs->surface;
    const auto from_axis = [](const Frame& frame, const Vector3d& c) {
        return frame.z.cross(c - frame.origin).norm();
    };
    for (int i = 0; i <= 12; ++i) {
        for (int j = 0; j <= 6; ++j) {
            const SurfaceJet jet = evaluate(s, s.knots_u.back() * i / 12.0, j / 6.0);
            const Vector3d n = jet.u.cross(jet.v).normalized();
            // One of the two sides of the surface is the ball's.
            const double miss =
                std::min(std::hypot(from_axis(one.frame, jet.point + r * n) - a - r,
                                    from_axis(two.frame, jet.point + r * n) - b - r),
                         std::hypot(from_axis(one.frame, jet.point - r * n) - a - r,
                                    from_axis(two.frame, jet.point - r * n) - b - r));
            EXPECT_LT(miss, 1e-7);
        }
    }
}

TEST(RollingBall, IsNotGuessedBetweenSidesOfVaryingDistance) {
    // A plane, and a cylinder that leans on it: no radius fits all along.
    Frame leaning = windows::tilted();
    leaning.origin += 6.0 * leaning.x;
    const Vector3d z = (leaning.z + 0.3 * leaning.x).normalized();
    leaning = frame_along(leaning.origin, z);
    Post post(4.0, 1.5, 1.0);
    Hole hole = post.hole;
    hole.loops[0].ribbons[1] = side_on(Cylinder{leaning, 2.0}, false, {2.0, 1.0}, {0.3, 3.0}, 2);
    EXPECT_TRUE(guess_balls(border_of(hole)).empty());
}

}  // namespace
}  // namespace suture::recognise

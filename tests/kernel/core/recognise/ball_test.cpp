#include "suture/fill/recognise/ball.h"

#include "support/windows.h"
#include "suture/fill/recognise.h"
#include "suture/fill/recognise/chain.h"
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
        const auto arcs =
            chain_surface({guesses.front()}, -post.r, border, 1e-9 * post.hole.diameter);
        ASSERT_TRUE(arcs) << arcs.error().message;
        EXPECT_LT(arcs->error, 1e-9 * post.hole.diameter);
        const Surface torus = post.truth(scale);
        const SplineSurface& s = arcs->surface;
        double off = 0.0;
        for (int i = 0; i <= 20; ++i) {
            for (int j = 0; j <= 10; ++j) {
                const double v = s.knots_v.back() * i / 20.0;
                off = std::max(off,
                               std::abs(distance_to(torus, evaluate(s, j / 10.0, v).point).value));
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
    const auto arcs = fit_arcs({{ball, *path}}, 1e-9);
    ASSERT_TRUE(arcs) << arcs.error().message;
    const SplineSurface& s = arcs->surface;
    const auto from_axis = [](const Frame& frame, const Vector3d& c) {
        return frame.z.cross(c - frame.origin).norm();
    };
    for (int i = 0; i <= 12; ++i) {
        for (int j = 0; j <= 6; ++j) {
            const SurfaceJet jet = evaluate(s, j / 6.0, s.knots_v.back() * i / 12.0);
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

/// A ball that rolls between a plane and a ring that touches it in a point of its inner equator:
/// there the two contacts meet, and the hole has a corner.
struct Corner {
    static constexpr double R = 5.0, a = 2.0, r = 1.0, b = a + r, c = R - b, far = 2.0;

    static Vector3d centre(double t) {
        const double rho = std::hypot(c, t);
        return {c, t, t * std::sqrt((b + R - rho) / (rho + c))};
    }
    static Vector3d contact(bool on_plane, double t) {
        const Vector3d p = centre(t);
        const Vector3d q = R * Vector3d(p.x(), p.y(), 0.0).normalized();
        return on_plane ? Vector3d(p + r * Vector3d::UnitX()) : Vector3d(q + a / b * (p - q));
    }
    static Ribbon side(const Surface& surface, bool reversed, bool on_plane, double from,
                       double to) {
        Ribbon ribbon;
        ribbon.edge = ribbon.face = on_plane ? 1 : 2;
        const auto t = [from, to](double s) { return from + s * (to - from); };
        ribbon.support = Support{surface, reversed, [surface, on_plane, t](double s) {
                                     return parameters_of(surface, contact(on_plane, t(s)));
                                 }};
        ribbon.at = along([on_plane, t](double s) { return contact(on_plane, t(s)); },
                          [t](double s) { return centre(t(s)); });
        return ribbon;
    }
    /// Points whose normals lead to a centre.
    static std::function<RibbonPoint(double)> along(std::function<Vector3d(double)> point,
                                                    std::function<Vector3d(double)> centre) {
        return [point = std::move(point), centre = std::move(centre)](double s) {
            constexpr double kStep = 1e-6;
            RibbonPoint p;
            p.point = point(s);
            p.normal = (centre(s) - p.point).normalized();
            p.tangent = (point(s + kStep) - point(s - kStep)) / (2.0 * kStep);
            p.inward = p.normal.cross(p.tangent).normalized();
            p.curvature.setZero();
            return p;
        };
    }
    static Hole hole() {
        Frame wall;
        wall.origin = Vector3d(c + r, 0.0, 0.0);
        wall.x = Vector3d::UnitY();
        wall.y = Vector3d::UnitZ();
        wall.z = Vector3d::UnitX();
        Ribbon arc;
        arc.edge = arc.face = 3;
        const Vector3d middle = centre(far);
        const Vector3d from = contact(true, far) - middle;
        const Vector3d to = contact(false, far) - middle;
        const double angle = std::acos(from.dot(to) / (r * r));
        arc.at = along(
            [=](double s) -> Vector3d {
                return middle + (std::sin((1.0 - s) * angle) * from + std::sin(s * angle) * to) /
                                    std::sin(angle);
            },
            [middle](double) { return middle; });
        Hole result;
        result.loops.push_back({{side(Plane{wall}, true, true, 0.0, far), arc,
                                 side(Torus{Frame(), R, a}, false, false, far, 0.0)}});
        result.diameter = windows::diameter_of(result);
        return result;
    }
};

TEST(RollingBall, EndsInTheCornerWhereItsTwoSidesMeet) {
    const Hole hole = Corner::hole();
    const Vector3d inward = hole.loops[0].ribbons[0].at(0.5).inward;
    ASSERT_GT(inward.dot(Corner::contact(false, 1.0) - Corner::contact(true, 1.0)), 0.0);
    Recognised found;
    FillOptions options;
    options.recognised = [&](const Recognised& what) { found = what; };
    const auto fill = fill_recognise(hole, options);
    ASSERT_TRUE(fill) << fill.error().message;
    EXPECT_EQ(found.kind, "rolling ball");
    EXPECT_NEAR(found.parameters.front().second, Corner::r, 1e-9);
    const auto fit = windows::fit_of(hole, fill->patches.front());
    EXPECT_LT(fit.gap, 1e-7);
    // Also in the corner the face shows its outside.
    EXPECT_LT(fit.angle, 1e-4);
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

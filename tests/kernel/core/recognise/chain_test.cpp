#include "suture/fill/recognise/chain.h"

#include "support/windows.h"
#include "suture/fill/recognise.h"
#include "suture/fill/recognise/form.h"
#include "suture/fill/recognise/surface_foot.h"

#include <gtest/gtest.h>

namespace suture::recognise {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

/// The fillet at the foot of a rounded edge: a ball of radius r between the floor z = 0 and a wall
/// y = -R that bends about the z axis into a wall x = R. On the floor there is one side, on the
/// walls there are three.
class RoundedFoot {
  public:
    static constexpr double R = 3.0, r = 1.2, left = 4.0, right = 2.5;

    explicit RoundedFoot(double scale, double kink = 0.0) : frame_(windows::tilted(scale)) {
        const auto along = [](double from, double to) {
            return [from, to](double s) { return from + s * (to - from); };
        };
        std::vector<Ribbon> sides;
        sides.push_back(side(scale, along(0.0, length()), /*on_floor=*/true, floor(), 1));
        sides.push_back(cap(scale, length(), /*up=*/true, 2));
        sides.push_back(
            side(scale, along(length(), left + arc()), /*on_floor=*/false, wall(scale, 2), 3));
        sides.push_back(
            side(scale, along(left + arc(), left), /*on_floor=*/false, wall(scale, 1), 4));
        Surface last = wall(scale, 0);
        frame_of(last).origin += kink * scale * frame_of(last).z;
        sides.push_back(side(scale, along(left, 0.0), /*on_floor=*/false, last, 5));
        sides.push_back(cap(scale, 0.0, /*up=*/false, 6));
        hole_.loops.push_back({std::move(sides)});
        hole_.diameter = windows::diameter_of(hole_);
    }

    [[nodiscard]] const Hole& hole() const { return hole_; }

    /// Of a point from the fillet: two cylinders and a torus.
    [[nodiscard]] double distance(const Vector3d& point, double scale) const {
        const Vector3d d = (point - frame_.origin) / scale;
        const Vector3d p(d.dot(frame_.x), d.dot(frame_.y), d.dot(frame_.z));
        const double out = p.x() <= 0.0 ? -p.y() : p.y() >= 0.0 ? p.x() : std::hypot(p.x(), p.y());
        return scale * std::abs(std::hypot(out - (R + r), p.z() - r) - r);
    }

  private:
    Frame frame_;
    Hole hole_;

    /// The path of the ball's centre, by its length on the walls.
    static constexpr double arc() { return 0.5 * kPi * R; }
    static constexpr double length() { return left + arc() + right; }
    /// The direction from the wall outwards, and the foot on the wall at z = 0.
    static std::pair<Vector3d, Vector3d> at(double t) {
        if (t < left) {
            return {-Vector3d::UnitY(), Vector3d(t - left, -R, 0.0)};
        }
        if (t > left + arc()) {
            return {Vector3d::UnitX(), Vector3d(R, t - left - arc(), 0.0)};
        }
        const double phi = (t - left) / R;
        const Vector3d out(std::sin(phi), -std::cos(phi), 0.0);
        return {out, R * out};
    }
    static Vector3d centre(double t) {
        const auto [out, foot] = at(t);
        return foot + r * out + r * Vector3d::UnitZ();
    }
    [[nodiscard]] Vector3d to_model(double scale, const Vector3d& p) const {
        return frame_.origin + scale * turned(p);
    }
    [[nodiscard]] Vector3d turned(const Vector3d& p) const {
        return p.x() * frame_.x + p.y() * frame_.y + p.z() * frame_.z;
    }
    [[nodiscard]] Surface floor() const { return Plane{frame_}; }
    [[nodiscard]] Surface wall(double scale, int which) const {
        if (which == 1) {
            return Cylinder{frame_, R * scale};
        }
        Frame frame;
        frame.z = which == 0 ? -frame_.y : frame_.x;
        frame.x = frame_.z;
        frame.y = frame.z.cross(frame.x);
        frame.origin = frame_.origin + R * scale * frame.z;
        return Plane{frame};
    }
    using Parameter = std::function<double(double)>;

    /// Points whose normals lead to the ball's centre: the fillet lies on the side of the air.
    static Ribbon ribbon_of(const std::function<std::pair<Vector3d, Vector3d>(double)>& at,
                            int number) {
        Ribbon ribbon;
        ribbon.edge = ribbon.face = number;
        ribbon.at = [at](double s) {
            constexpr double kStep = 1e-6;
            RibbonPoint p;
            p.point = at(s).first;
            p.normal = at(s).second;
            p.tangent = (at(s + kStep).first - at(s - kStep).first) / (2.0 * kStep);
            p.inward = p.normal.cross(p.tangent).normalized();
            p.curvature.setZero();
            return p;
        };
        return ribbon;
    }
    [[nodiscard]] Ribbon side(double scale, const Parameter& t, bool on_floor,
                              const Surface& support, int number) const {
        Ribbon ribbon = ribbon_of(
            [=, this](double s) {
                const auto [out, foot] = at(t(s));
                const Vector3d n = on_floor ? Vector3d::UnitZ() : out;
                return std::pair(to_model(scale, centre(t(s)) - r * n), turned(n));
            },
            number);
        ribbon.support = Support{support, false, [support, at = ribbon.at](double s) {
                                     return parameters_of(support, at(s).point);
                                 }};
        return ribbon;
    }
    /// A quarter of the ball's circle at an end.
    [[nodiscard]] Ribbon cap(double scale, double t, bool up, int number) const {
        return ribbon_of(
            [=, this](double s) {
                const double phi = 0.5 * kPi * (up ? s : 1.0 - s);
                const Vector3d n = std::cos(phi) * Vector3d::UnitZ() + std::sin(phi) * at(t).first;
                return std::pair(to_model(scale, centre(t) - r * n), turned(n));
            },
            number);
    }
};

TEST(RollingBall, GoesFromPairToPair) {
    for (const double scale : {1e-3, 1.0, 1e3}) {
        const RoundedFoot foot(scale);
        const Border border = border_of(foot.hole());
        const auto chain = find_chain(guess_balls(border), border);
        ASSERT_EQ(chain.size(), 3U);
        const double size = foot.hole().diameter;
        const auto arcs = chain_surface(chain, -RoundedFoot::r * scale, border, 1e-9 * size);
        ASSERT_TRUE(arcs) << arcs.error().message;
        EXPECT_LT(arcs->error, 1e-9 * size);
        const SplineSurface& s = arcs->surface;
        double off = 0.0;
        double turn = 0.0;
        for (int j = 0; j <= 10; ++j) {
            for (int i = 0; i <= 200; ++i) {
                const double v = s.knots_v.back() * i / 200.0;
                off = std::max(off, foot.distance(evaluate(s, j / 10.0, v).point, scale));
            }
            // The tangent planes on both sides of each knot.
            for (const double knot : s.knots_v) {
                const double step = 1e-9 * s.knots_v.back();
                const auto normal = [&](double v) {
                    const SurfaceJet jet =
                        evaluate(s, j / 10.0, std::clamp(v, 0.0, s.knots_v.back()));
                    return Vector3d(jet.u.cross(jet.v).normalized());
                };
                turn = std::max(turn, normal(knot - step).cross(normal(knot + step)).norm());
            }
        }
        EXPECT_LT(off, 1e-8 * size);
        EXPECT_LT(turn, 1e-6);
        const SurfaceFoot on(s);
        EXPECT_LT(measure([&](const Vector3d& p) { return on.foot(p); }, border).gap, 1e-8);
    }
}

TEST(FillRecognise, GivesBackABallAlongFourSides) {
    for (const double scale : {1e-3, 1.0, 1e3}) {
        const RoundedFoot foot(scale);
        std::optional<Recognised> told;
        FillOptions options;
        options.recognised = [&](const Recognised& what) { told = what; };
        const auto fill = fill_recognise(foot.hole(), options);
        ASSERT_TRUE(fill) << fill.error().message;
        EXPECT_LT(windows::fit_of(foot.hole(), fill->patches.front()).gap,
                  1e-7 * foot.hole().diameter);
        EXPECT_LT(windows::fit_of(foot.hole(), fill->patches.front()).angle, 1e-5);
        ASSERT_TRUE(told);
        EXPECT_EQ(told->kind, "rolling ball");
        EXPECT_NEAR(told->parameters.front().second, RoundedFoot::r * scale, 1e-9 * scale);
        EXPECT_EQ(told->from, "a ball that touches 4 neighbours, a pair at a time");
    }
}

// The first wall's surface lies 1 % of the hole behind its own edge: a ball on it is elsewhere.
TEST(RollingBall, DoesNotLeapFromPairToPair) {
    const RoundedFoot foot(1.0, /*kink=*/-0.1);
    const Border border = border_of(foot.hole());
    const auto chain = find_chain(guess_balls(border), border);
    ASSERT_GT(chain.size(), 1U);
    const auto arcs = chain_surface(chain, -RoundedFoot::r, border, 1e-8);
    ASSERT_FALSE(arcs);
    EXPECT_NE(arcs.error().message.find("leaps by"), std::string::npos) << arcs.error().message;
}

}  // namespace
}  // namespace suture::recognise

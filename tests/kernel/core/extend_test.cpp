#include "suture/fill/extend.h"

#include "support/trim_of.h"
#include "support/windows.h"

#include <gtest/gtest.h>

namespace suture {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using windows::tilted;
using windows::Window;

std::vector<Surface> closed_forms(double scale) {
    return {Plane{tilted(scale)}, Cylinder{tilted(scale), 2.0 * scale},
            Cone{tilted(scale), 1.5 * scale, -0.4}, Sphere{tilted(scale), 3.0 * scale},
            Torus{tilted(scale), 5.0 * scale, 1.25 * scale}};
}

bool has_length_v(const Surface& s) {
    return s.index() <= 2;
}

Window window_of(const Surface& surface, double u0, double scale, bool reversed) {
    Window w;
    w.centre = {u0, 0.1};
    w.radius = {0.6, 0.35};
    if (std::holds_alternative<Plane>(surface)) {
        w.centre.x() *= scale;
        w.radius.x() *= scale;
    }
    if (has_length_v(surface)) {
        w.centre.y() *= scale;
        w.radius.y() *= scale;
    }
    w.reversed = reversed;
    return w;
}

// u0 = pi puts the window across the place where atan2 jumps, 0 across OCCT's own seam.
TEST(FillExtend, RestoresEveryClosedFormAlsoAcrossItsSeam) {
    for (const double scale : {1e-3, 1.0, 1e3}) {
        for (const double u0 : {0.0, 1.0, kPi}) {
            for (const bool reversed : {false, true}) {
                for (const Surface& s : closed_forms(scale)) {
                    const Hole hole = windows::window_in(s, window_of(s, u0, scale, reversed));
                    const auto fill = fill_extend(hole, {});
                    ASSERT_TRUE(fill) << fill.error().message;
                    const Patch& patch = fill->patches.front();
                    EXPECT_EQ(patch.surface.index(), s.index());
                    EXPECT_EQ(patch.reversed, reversed);
                    const auto fit = windows::fit_of(hole, patch);
                    EXPECT_LT(fit.gap, 1e-13 * 20 * scale) << kind_name(s) << " " << u0;
                    EXPECT_LT(fit.angle, 1e-12) << kind_name(s) << " " << u0;
                    EXPECT_LT(windows::largest_jump(patch), 1e-12 * std::max(1.0, scale));
                }
            }
        }
    }
}

TEST(FillExtend, KeepsTheSphereAwayFromItsPoles) {
    const Sphere sphere{tilted(), 3.0};
    Window w;  // around the pole: all the way around the axis
    w.sides = 4;
    const Hole around = [&] {
        Hole hole;
        auto& loop = hole.loops.emplace_back();
        for (int side = 0; side < 4; ++side) {
            // The circle v = 1.2, walked so that the pole is on the left.
            Ribbon r;
            r.edge = side + 1;
            r.face = side + 1;
            r.support = Support{sphere, false,
                                [side](double s) { return Vector2d(kPi / 2 * (side + s), 1.2); }};
            r.at = [sphere, side](double s) {
                const SurfaceJet jet = evaluate(Surface(sphere), kPi / 2 * (side + s), 1.2);
                RibbonPoint p;
                p.point = jet.point;
                p.normal = jet.u.cross(jet.v).normalized();
                p.tangent = jet.u * kPi / 2;
                p.inward = p.normal.cross(p.tangent).normalized();
                p.curvature.setZero();
                return p;
            };
            loop.ribbons.push_back(r);
        }
        hole.diameter = windows::diameter_of(hole);
        return hole;
    }();
    const auto fill = fill_extend(around, {});
    ASSERT_TRUE(fill) << fill.error().message;
    const Patch& patch = fill->patches.front();
    EXPECT_LT(windows::fit_of(around, patch).gap, 1e-14 * 30);
    EXPECT_LT(windows::largest_jump(patch), 1e-12);
    for (const EdgeUse& use : patch.wires.front()) {
        EXPECT_LT(std::abs(use.at(0.5).y()), 0.5);  // the cap has an opening of 0.37 rad
    }
}

TEST(FillExtend, RefusesNeighboursOnDifferentSurfacesNamingBothFaces) {
    const Cylinder a{tilted(), 2.0};
    Cylinder b = a;
    b.radius = 2.5;
    const Window w{{1.0, 0.0}, {0.5, 0.5}, 3, false};
    Hole hole = windows::window_in(a, w);
    hole.loops[0].ribbons[1] = windows::ribbon_on(b, w, 1);
    const auto fill = fill_extend(hole, {});
    ASSERT_FALSE(fill);
    EXPECT_EQ(fill.error().code, ErrorCode::Refused);
    EXPECT_NE(fill.error().message.find("face 1 (cylinder) and face 2 (cylinder)"),
              std::string::npos)
        << fill.error().message;
}

TEST(FillExtend, RefusesANeighbourWithoutClosedForm) {
    Hole hole = windows::window_in(Cylinder{tilted(), 2.0}, {{1.0, 0.0}, {0.5, 0.5}, 4, false});
    hole.loops[0].ribbons[2].support.reset();
    const auto fill = fill_extend(hole, {});
    ASSERT_FALSE(fill);
    EXPECT_NE(fill.error().message.find("face 3"), std::string::npos) << fill.error().message;
}

TEST(FillExtend, RefusesABandAroundTheAxis) {
    const Cylinder cylinder{tilted(), 2.0};
    Hole hole = windows::window_in(cylinder, {{1.0, 0.0}, {0.5, 0.5}, 3, false});
    for (int side = 0; side < 3; ++side) {
        auto& ribbon = hole.loops[0].ribbons[static_cast<std::size_t>(side)];
        ribbon.at = [cylinder, side](double s) {
            const double u = 2.0 * kPi / 3.0 * (side + s);
            const SurfaceJet jet = evaluate(Surface(cylinder), u, 1.0);
            return RibbonPoint{jet.point, jet.u * 2.0 * kPi / 3.0, jet.u.cross(jet.v).normalized(),
                               jet.v, Eigen::Matrix3d::Zero()};
        };
    }
    const auto fill = fill_extend(hole, {});
    ASSERT_FALSE(fill);
    EXPECT_NE(fill.error().message.find("all the way around"), std::string::npos);
}

/// A loop all the way around a surface, along one coordinate (`c`) with the other one at `at` and
/// waved by `wave`, in three sides from `start` on; forwards or backwards.
RibbonLoop ring(const Surface& surface, int c, double at, double wave, double start, double sign,
                bool reversed) {
    RibbonLoop loop;
    for (int side = 0; side < 3; ++side) {
        const auto uv = [=](double s) {
            const double angle = start + sign * 2.0 * kPi * (side + s) / 3.0;
            Vector2d p;
            p[c] = angle;
            p[1 - c] = at + wave * std::sin(2.0 * angle);
            return p;
        };
        const auto velocity = [=](double s) {
            Vector2d p;
            p[c] = sign * 2.0 * kPi / 3.0;
            p[1 - c] = p[c] * wave * 2.0 * std::cos(2.0 * uv(s)[c]);
            return p;
        };
        Ribbon ribbon;
        ribbon.edge = ribbon.face = side + 1;
        ribbon.support = Support{surface, reversed, uv};
        ribbon.at = [=](double s) {
            const SurfaceJet jet = evaluate(surface, uv(s).x(), uv(s).y());
            RibbonPoint p;
            p.point = jet.point;
            p.normal = (reversed ? -1.0 : 1.0) * jet.u.cross(jet.v).normalized();
            p.tangent = velocity(s).x() * jet.u + velocity(s).y() * jet.v;
            p.inward = p.normal.cross(p.tangent).normalized();
            p.curvature.setZero();
            return p;
        };
        loop.ribbons.push_back(ribbon);
    }
    return loop;
}

/// One closed wire that walks one seam twice, a period apart, the first time with the patch on its
/// other side.
void expect_well_seamed(const FillResult& fill) {
    const Patch& patch = fill.patches.front();
    EXPECT_EQ(fill.inner_edges.size(), 1U);
    ASSERT_EQ(patch.wires.size(), 1U);
    EXPECT_LT(windows::largest_jump(patch), 1e-9);
    std::vector<const EdgeUse*> seam;
    for (const EdgeUse& use : patch.wires.front()) {
        if (use.loop < 0) {
            seam.push_back(&use);
        }
    }
    ASSERT_EQ(seam.size(), 2U);
    EXPECT_FALSE(seam[0]->backwards);
    EXPECT_TRUE(seam[1]->backwards);
    const Vector2d period = seam[0]->at(0.0) - seam[1]->at(0.0);
    EXPECT_NEAR(period.cwiseAbs().maxCoeff(), 2.0 * kPi, 1e-12);
    EXPECT_LT((seam[0]->at(0.7) - seam[1]->at(0.7) - period).norm(), 1e-12);
}

TEST(FillExtend, CutsABandOpenBetweenTwoLoops) {
    struct Case {
        Surface surface;
        int around;
        double low, high;
    };
    const std::vector<Case> cases = {{Cylinder{tilted(), 2.0}, 0, -1.0, 3.0},
                                     {Cone{tilted(), 1.5, 0.4}, 0, 0.0, 2.0},
                                     {Sphere{tilted(), 3.0}, 0, -0.6, 0.8},
                                     {Torus{tilted(), 5.0, 1.25}, 0, 2.5, 4.5},
                                     {Torus{tilted(), 5.0, 1.25}, 1, -0.7, 0.9}};
    for (const Case& c : cases) {
        for (const bool reversed : {false, true}) {
            for (const double start : {0.0, 0.4, 2.0}) {
                // Left of a loop that goes along u lies v, left of one along v lies -u.
                const double sign = (c.around == 0) != reversed ? 1.0 : -1.0;
                Hole hole;
                hole.loops = {ring(c.surface, c.around, c.low, 0.1, 0.0, sign, reversed),
                              ring(c.surface, c.around, c.high, 0.1, start, -sign, reversed)};
                hole.diameter = windows::diameter_of(hole);
                const auto fill = fill_extend(hole, {});
                ASSERT_TRUE(fill) << kind_name(c.surface) << fill.error().message;
                const Patch& patch = fill->patches.front();
                EXPECT_EQ(patch.reversed, reversed);
                const auto fit = windows::fit_of(hole, patch);
                EXPECT_LT(fit.gap, 1e-12);
                EXPECT_LT(fit.angle, 1e-12);
                expect_well_seamed(*fill);
            }
        }
    }
}

TEST(FillExtend, GoesOnToTheTipOfACone) {
    for (const double half_angle : {0.4, -0.4, 1.3}) {
        const Surface cone = Cone{tilted(), 1.5, half_angle};
        const double tip = -1.5 / std::sin(half_angle);
        for (const bool reversed : {false, true}) {
            const double sign = (tip > 0.0) != reversed ? 1.0 : -1.0;
            Hole hole;
            hole.loops = {ring(cone, 0, 0.0, 0.2, 1.0, sign, reversed)};
            hole.diameter = windows::diameter_of(hole);
            const auto fill = fill_extend(hole, {});
            ASSERT_TRUE(fill) << fill.error().message;
            const Patch& patch = fill->patches.front();
            EXPECT_LT(windows::fit_of(hole, patch).gap, 1e-12);
            expect_well_seamed(*fill);
            ASSERT_EQ(fill->inner_vertices.size(), 1U);
            EXPECT_NEAR(patch.wires.front().back().at(1.0).y(), tip, 1e-12);
        }
    }
}

TEST(FillExtend, RefusesALoopWithTheHoleOnTheOpenSideOfACone) {
    const Surface cone = Cone{tilted(), 1.5, 0.4};
    Hole hole;
    hole.loops = {ring(cone, 0, 0.0, 0.0, 0.0, 1.0, false)};
    hole.diameter = windows::diameter_of(hole);
    const auto fill = fill_extend(hole, {});
    ASSERT_FALSE(fill);
    EXPECT_NE(fill.error().message.find("nothing ends it"), std::string::npos);
}

TEST(FillExtend, RefusesTwoLoopsWithTheMaterialBetweenThem) {
    const Surface cylinder = Cylinder{tilted(), 2.0};
    Hole hole;
    hole.loops = {ring(cylinder, 0, 0.0, 0.0, 0.0, -1.0, false),
                  ring(cylinder, 0, 3.0, 0.0, 0.0, 1.0, false)};
    hole.diameter = windows::diameter_of(hole);
    const auto fill = fill_extend(hole, {});
    ASSERT_FALSE(fill);
    EXPECT_NE(fill.error().message.find("between the two loops"), std::string::npos);
}

TEST(FillExtend, RefusesNeighboursOfOppositeOrientation) {
    const Sphere sphere{tilted(), 3.0};
    Hole hole = windows::window_in(sphere, {{1.0, 0.1}, {0.5, 0.4}, 3, false});
    auto& ribbon = hole.loops[0].ribbons[1];
    ribbon.at = [at = ribbon.at](double s) {
        RibbonPoint p = at(s);
        p.normal = -p.normal;
        return p;
    };
    const auto fill = fill_extend(hole, {});
    ASSERT_FALSE(fill);
    EXPECT_NE(fill.error().message.find("oriented against"), std::string::npos);
}

TEST(FillExtend, FillsWithAnIslandOnTheSamePeriod) {
    const Torus torus{tilted(), 5.0, 1.25};
    Hole hole = windows::window_in(torus, {{kPi, 3.0}, {0.8, 0.9}, 3, false});
    // The island's ribbons walk the other way round, one period further.
    Hole island = windows::window_in(torus, {{kPi - 2.0 * kPi, 3.0}, {0.2, -0.2}, 2, false});
    hole.loops.push_back(island.loops.front());
    const auto fill = fill_extend(hole, {});
    ASSERT_TRUE(fill) << fill.error().message;
    const Patch& patch = fill->patches.front();
    ASSERT_EQ(patch.wires.size(), 2U);
    EXPECT_LT(windows::fit_of(hole, patch).gap, 1e-12);
    const Vector2d outer = test::trim_of(patch, 0, 0)(0.0);
    EXPECT_LT((test::trim_of(patch, 1, 0)(0.0) - outer).norm(), 1.0);
}

/// A bicubic x quadratic sheet over [0,2] x [0,1], closed in u if asked.
SplineSurface sheet(bool closed) {
    SplineSurface s;
    s.degree_u = 3;
    s.degree_v = 2;
    s.knots_u = {0, 0, 0, 0, 0.4, 0.8, 1.2, 1.6, 2, 2, 2, 2};
    s.knots_v = {0, 0, 0, 0.6, 1, 1, 1};
    const int nu = s.count_u();
    const int nv = s.count_v();
    s.poles.resize(3, nu * nv);
    for (int j = 0; j < nv; ++j) {
        for (int i = 0; i < nu; ++i) {
            const double phi = 2.0 * kPi * i / (nu - 1);
            s.poles.col(s.index(i, j)) =
                closed ? Vector3d(std::cos(phi), std::sin(phi), j + 0.1 * std::sin(2.0 * phi))
                       : Vector3d(i, 2.0 * j, 0.3 * std::sin(i * 1.3) * j);
        }
    }
    if (closed) {
        for (int j = 0; j < nv; ++j) {
            s.poles.col(s.index(nu - 1, j)) = s.poles.col(s.index(0, j));
        }
    }
    return s;
}

TEST(FillExtend, ContinuesASplineInsideItsDomain) {
    const Surface s = sheet(false);
    const Hole hole = windows::window_in(s, {{1.0, 0.5}, {0.5, 0.2}, 5, true});
    const auto fill = fill_extend(hole, {});
    ASSERT_TRUE(fill) << fill.error().message;
    EXPECT_TRUE(fill->patches.front().reversed);
    EXPECT_EQ(windows::fit_of(hole, fill->patches.front()).gap, 0.0);
    EXPECT_EQ(std::get<SplineSurface>(fill->patches.front().surface).knots_u,
              std::get<SplineSurface>(s).knots_u);
}

TEST(FillExtend, ContinuesASplineBeyondItsDomain) {
    const Surface s = sheet(false);
    // evaluate() goes on beyond the domain, so the ribbons are exact out there.
    const Hole hole = windows::window_in(s, {{1.8, 0.9}, {0.4, 0.3}, 5, false});
    const auto fill = fill_extend(hole, {});
    ASSERT_TRUE(fill) << fill.error().message;
    const auto& longer = std::get<SplineSurface>(fill->patches.front().surface);
    EXPECT_GT(longer.knots_u.back(), 2.15);
    EXPECT_GT(longer.knots_v.back(), 1.15);
    EXPECT_LT(windows::fit_of(hole, fill->patches.front()).gap, 1e-12);
}

TEST(FillExtend, ContinuesAClosedSplineAcrossItsSeam) {
    const SplineSurface s = sheet(true);
    Hole hole = windows::window_in(Surface(s), {{0.0, 0.5}, {0.3, 0.2}, 4, false});
    // A model keeps every pcurve inside of the domain: sides left of the seam lie one period on.
    for (Ribbon& ribbon : hole.loops[0].ribbons) {
        const double shift = ribbon.support->uv(0.5).x() < 0.0 ? 2.0 : 0.0;
        const auto uv = ribbon.support->uv;
        const auto inside = [uv, shift](double t) -> Vector2d {
            return uv(t) + Vector2d(shift, 0.0);
        };
        ribbon.support->uv = inside;
        ribbon.at = [s, inside](double t) {
            const SurfaceJet jet = evaluate(s, inside(t).x(), inside(t).y());
            return RibbonPoint{jet.point, jet.u, jet.u.cross(jet.v).normalized(), jet.v,
                               Eigen::Matrix3d::Zero()};
        };
    }
    const auto fill = fill_extend(hole, {});
    ASSERT_TRUE(fill) << fill.error().message;
    const Patch& patch = fill->patches.front();
    EXPECT_LT(windows::fit_of(hole, patch).gap, 1e-12);
    EXPECT_LT(windows::largest_jump(patch), 1e-12);
    // Cut open elsewhere: no point has two places.
    const auto& cut = std::get<SplineSurface>(patch.surface);
    EXPECT_LT(cut.knots_u.back() - cut.knots_u.front(), 1.9);
}

}  // namespace
}  // namespace suture

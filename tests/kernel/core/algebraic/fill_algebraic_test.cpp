#include "suture/fill/algebraic.h"

#include <Eigen/Geometry>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace suture {
namespace {

using Eigen::Vector3d;
using testing::HasSubstr;

/// Where an edge of cylinders of one radius meets: n planes at the same tilt, the edges between
/// neighbouring ones rounded. What is missing is part of a sphere.
struct VertexCorner {
    int sides = 3;
    double radius = 1.0;
    Eigen::Isometry3d place = Eigen::Isometry3d::Identity();
};

Ribbon arc(const Vector3d& centre, const Vector3d& from, const Vector3d& to, double radius,
           int number) {
    const Vector3d axis = from.cross(to).normalized();
    const Vector3d side = axis.cross(from);
    const double angle = std::acos(from.dot(to));
    Ribbon ribbon;
    ribbon.edge = number;
    ribbon.face = 100 + number;
    ribbon.at = [=](double s) {
        const double a = s * angle;
        RibbonPoint p;
        p.normal = std::cos(a) * from + std::sin(a) * side;
        p.point = centre + radius * p.normal;
        const Vector3d along = std::cos(a) * side - std::sin(a) * from;
        p.tangent = radius * angle * along;
        p.inward = p.normal.cross(along);
        p.curvature = -along * along.transpose() / radius;
        return p;
    };
    Support support;
    support.surface = Cylinder{{centre, from, side, axis}, radius};
    ribbon.support = support;
    return ribbon;
}

Hole hole_of(const VertexCorner& corner) {
    constexpr double kTilt = 0.7;
    std::vector<Vector3d> normals;
    for (int i = 0; i < corner.sides; ++i) {
        // Not regular: one plane stands steeper.
        const double azimuth = 2.0 * kPi * i / corner.sides + (i == 1 ? 0.1 : 0.0);
        const double tilt = kTilt + (i == 0 ? 0.15 : 0.0);
        normals.push_back(corner.place.linear() * Vector3d(std::sin(tilt) * std::cos(azimuth),
                                                           std::sin(tilt) * std::sin(azimuth),
                                                           std::cos(tilt)));
    }
    Hole hole;
    hole.loops.resize(1);
    Eigen::AlignedBox3d box;
    for (int i = 0; i < corner.sides; ++i) {
        const auto next = static_cast<std::size_t>((i + 1) % corner.sides);
        hole.loops[0].ribbons.push_back(arc(corner.place.translation(),
                                            normals[static_cast<std::size_t>(i)], normals[next],
                                            corner.radius, i + 1));
        box.extend(hole.loops[0].ribbons.back().at(0.0).point);
        box.extend(hole.loops[0].ribbons.back().at(0.5).point);
    }
    hole.diameter = box.diagonal().norm();
    return hole;
}

FillOptions options_for(const VertexCorner& corner) {
    FillOptions options;
    options.tolerance.linear = 1e-3 * corner.radius;
    return options;
}

/// Largest distance from the sphere, and of the faces from the ribbons, over the radius; largest
/// angle at the ribbons and between faces.
struct Errors {
    double shape = 0.0, gap = 0.0, angle = 0.0;
};

double angle_between(const Vector3d& a, const Vector3d& b) {
    return std::atan2(a.cross(b).norm(), a.dot(b));
}

Errors errors_of(const FillResult& fill, const Hole& hole, const VertexCorner& corner) {
    Errors errors;
    constexpr int kSamples = 21;
    std::vector<std::vector<SurfaceJet>> inner(fill.inner_edges.size());
    const auto meet = [&](const Vector3d& a, const Vector3d& b, const Vector3d& na,
                          const Vector3d& nb) {
        errors.gap = std::max(errors.gap, (a - b).norm() / corner.radius);
        errors.angle = std::max(errors.angle, angle_between(na, nb));
    };
    for (const Patch& patch : fill.patches) {
        for (const EdgeUse& use : patch.wires.front()) {
            const bool first = use.loop < 0 && inner[static_cast<std::size_t>(use.index)].empty();
            for (int n = 0; n <= kSamples; ++n) {
                const double s = static_cast<double>(n) / kSamples;
                const Eigen::Vector2d uv = use.at(s);
                const SurfaceJet jet = evaluate(patch.surface, uv.x(), uv.y());
                const Vector3d normal = jet.u.cross(jet.v);
                errors.shape = std::max(
                    errors.shape,
                    std::abs((jet.point - corner.place.translation()).norm() / corner.radius - 1));
                if (use.loop >= 0) {
                    const RibbonPoint p =
                        hole.loops[0].ribbons[static_cast<std::size_t>(use.index)].at(s);
                    meet(jet.point, p.point, normal, p.normal);
                } else if (first) {
                    inner[static_cast<std::size_t>(use.index)].push_back(jet);
                } else {
                    const SurfaceJet& other =
                        inner[static_cast<std::size_t>(use.index)][static_cast<std::size_t>(n)];
                    meet(jet.point, other.point, normal, other.u.cross(other.v));
                }
            }
        }
    }
    return errors;
}

TEST(FillAlgebraic, FindsTheSphereBetweenThreeToSixCylinders) {
    for (const int sides : {3, 4, 5, 6}) {
        SCOPED_TRACE(sides);
        const VertexCorner corner{sides, 1.0, Eigen::Isometry3d::Identity()};
        const Hole hole = hole_of(corner);
        const auto fill = fill_algebraic(hole, options_for(corner));
        ASSERT_TRUE(fill) << fill.error().message;
        EXPECT_EQ(fill->patches.size(), static_cast<std::size_t>(sides));
        const Errors errors = errors_of(*fill, hole, corner);
        EXPECT_LT(errors.shape, 1e-6);
        EXPECT_LT(errors.gap, 1e-6);
        EXPECT_LT(errors.angle, radians(0.01));
    }
}

TEST(FillAlgebraic, GivesTheSameAnywhereAndAtAnySize) {
    Eigen::Isometry3d place = Eigen::Isometry3d::Identity();
    place.rotate(Eigen::AngleAxisd(1.1, Vector3d(1.0, -2.0, 0.5).normalized()));
    place.pretranslate(Vector3d(40.0, -7.0, 3.0));
    for (const double radius : {1e-2, 10.0}) {
        const VertexCorner corner{4, radius, place};
        const Hole hole = hole_of(corner);
        const auto fill = fill_algebraic(hole, options_for(corner));
        ASSERT_TRUE(fill) << fill.error().message;
        const Errors errors = errors_of(*fill, hole, corner);
        EXPECT_LT(errors.shape, 1e-6);
        EXPECT_LT(errors.gap, 1e-6);
        EXPECT_LT(errors.angle, radians(0.01));
    }
}

TEST(FillAlgebraic, UsesInnerCellsWhereAskedTo) {
    const VertexCorner corner{4, 1.0, Eigen::Isometry3d::Identity()};
    const Hole hole = hole_of(corner);
    FillOptions options = options_for(corner);
    options.own["cells"] = {OptionKind::Word, {}, "inner"};
    options.own["degree"] = {OptionKind::Count, {3.0}, ""};
    const auto fill = fill_algebraic(hole, options);
    ASSERT_TRUE(fill) << fill.error().message;
    EXPECT_EQ(fill->patches.size(), 10U);  // 4 at sides, 4 at corners, 2 in the middle
    EXPECT_THAT(fill->notes.front(), HasSubstr("degree 3 in 9 cells"));
    const Errors errors = errors_of(*fill, hole, corner);
    EXPECT_LT(errors.gap, 1e-6);
    EXPECT_LT(errors.angle, radians(0.01));
}

TEST(FillAlgebraic, NeedsNoEquationOfTheNeighbours) {
    const VertexCorner corner{5, 1.0, Eigen::Isometry3d::Identity()};
    Hole hole = hole_of(corner);
    for (Ribbon& ribbon : hole.loops[0].ribbons) {
        ribbon.support.reset();
    }
    const auto fill = fill_algebraic(hole, options_for(corner));
    ASSERT_TRUE(fill) << fill.error().message;
    const Errors errors = errors_of(*fill, hole, corner);
    EXPECT_LT(errors.shape, 1e-6);
    EXPECT_LT(errors.angle, radians(0.01));
}

/// A window in a sphere whose edges are no plane curves: they leave great circles by a wave.
Hole wavy_window(const VertexCorner& corner, double wave) {
    Hole hole = hole_of(corner);
    for (Ribbon& ribbon : hole.loops[0].ribbons) {
        ribbon.support.reset();
        const auto point = [at = ribbon.at, c = corner.place.translation(), r = corner.radius,
                            wave](double s) -> Vector3d {
            const RibbonPoint p = at(s);
            const Vector3d off = p.normal + wave * std::sin(2.0 * kPi * s) * p.inward;
            return c + r * off.normalized();
        };
        ribbon.at = [point, c = corner.place.translation(), r = corner.radius](double s) {
            constexpr double kStep = 1e-5;
            RibbonPoint p;
            p.point = point(s);
            p.tangent = (point(s + kStep) - point(s - kStep)) / (2.0 * kStep);
            p.normal = (p.point - c) / r;
            p.inward = p.normal.cross(p.tangent).normalized();
            p.curvature = -(Eigen::Matrix3d::Identity() - p.normal * p.normal.transpose()) / r;
            return p;
        };
    }
    return hole;
}

TEST(FillAlgebraic, MeetsEdgesThatAreNotPlanar) {
    for (const double radius : {1.0, 1e-3, 1e3}) {
        SCOPED_TRACE(radius);
        const VertexCorner corner{4, radius, Eigen::Isometry3d::Identity()};
        const Hole hole = wavy_window(corner, 0.08);
        const auto fill = fill_algebraic(hole, options_for(corner));
        ASSERT_TRUE(fill) << fill.error().message;
        EXPECT_THAT(fill->notes.front(), HasSubstr("degree 2 in 4 cells"));
        const Errors errors = errors_of(*fill, hole, corner);
        EXPECT_LT(errors.shape, 1e-6);
        EXPECT_LT(errors.gap, 1e-6);
        EXPECT_LT(errors.angle, radians(0.01));
    }
}

TEST(FillAlgebraic, AsksNoMoreThanTheModelsOwnNoise) {
    const VertexCorner corner{4, 1.0, Eigen::Isometry3d::Identity()};
    Hole hole = hole_of(corner);
    // One neighbour leans by 0.05 deg: no polynomial is smooth at its corners and meets all.
    const double lean = radians(0.05);
    Ribbon& leaning = hole.loops[0].ribbons[2];
    leaning.at = [at = leaning.at, lean](double s) {
        RibbonPoint p = at(s);
        const Eigen::AngleAxisd turn(lean, p.tangent.normalized());
        p.normal = turn * p.normal;
        p.inward = turn * p.inward;
        return p;
    };
    const auto fill = fill_algebraic(hole, options_for(corner));
    ASSERT_TRUE(fill) << fill.error().message;
    EXPECT_LT(errors_of(*fill, hole, corner).angle, radians(0.12));
}

TEST(FillAlgebraic, RefusesWithTheReason) {
    const VertexCorner corner{3, 1.0, Eigen::Isometry3d::Identity()};
    const auto refusal = [&](const auto& spoil) {
        Hole hole = hole_of(corner);
        spoil(hole);
        const auto fill = fill_algebraic(hole, options_for(corner));
        return fill ? std::string("filled") : fill.error().message;
    };
    EXPECT_THAT(refusal([](Hole& hole) { hole.loops[0].ribbons.pop_back(); }),
                HasSubstr("2 sides"));
    EXPECT_THAT(refusal([](Hole& hole) { hole.loops.resize(2); }), HasSubstr("1 islands"));
    const auto with_k_3 = [&](const auto& spoil) {
        Hole hole = hole_of(corner);
        spoil(hole);
        FillOptions options = options_for(corner);
        options.own["k"] = {OptionKind::Count, {3.0}, ""};
        const auto fill = fill_algebraic(hole, options);
        return fill ? std::string("filled") : fill.error().message;
    };
    EXPECT_THAT(with_k_3([](Hole& hole) { hole.loops[0].ribbons[1].support.reset(); }),
                HasSubstr("edge 2 (face 102): G^3 asks for a neighbour with an equation"));
    EXPECT_THAT(with_k_3([](Hole& hole) {
                    Ribbon& ribbon = hole.loops[0].ribbons[2];
                    ribbon.at = [at = ribbon.at](double s) {
                        RibbonPoint p = at(s);
                        p.point += 0.1 * std::sin(2.0 * kPi * s) * p.inward;
                        return p;
                    };
                }),
                HasSubstr("edge 3 (face 103) is not planar"));
    EXPECT_THAT(refusal([](Hole& hole) {
                    Ribbon& ribbon = hole.loops[0].ribbons[0];
                    ribbon.at = [at = ribbon.at](double s) {
                        RibbonPoint p = at(s);
                        p.normal = Eigen::AngleAxisd(0.2, p.tangent.normalized()) * p.normal;
                        return p;
                    };
                }),
                HasSubstr("differ by 11.5 deg"));
}

}  // namespace
}  // namespace suture

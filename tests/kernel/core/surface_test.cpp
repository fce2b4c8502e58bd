#include "suture/model/surface.h"

#include "suture/base/contract.h"
#include "suture/base/tolerance.h"

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <gtest/gtest.h>

#include <cmath>

namespace suture {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

Frame tilted(double scale = 1.0) {
    const Eigen::AngleAxisd turn(0.7, Vector3d(1, -2, 0.5).normalized());
    return {scale * Vector3d(3, -1, 2), turn * Vector3d::UnitX(), turn * Vector3d::UnitY(),
            turn * Vector3d::UnitZ()};
}

std::vector<Surface> closed_forms(double scale) {
    return {Plane{tilted(scale)}, Cylinder{tilted(scale), 2.0 * scale},
            Cone{tilted(scale), 1.5 * scale, -0.4}, Sphere{tilted(scale), 3.0 * scale},
            Torus{tilted(scale), 5.0 * scale, 1.25 * scale}};
}

TEST(ClosedForms, DerivativesEqualFiniteDifferences) {
    for (const Surface& s : closed_forms(1.0)) {
        const double h = 1e-5;
        const double u = 0.8;
        const double v = 0.45;
        const SurfaceJet jet = evaluate(s, u, v);
        const auto at = [&](double a, double b) { return evaluate(s, a, b); };
        EXPECT_LT((jet.u - (at(u + h, v).point - at(u - h, v).point) / (2 * h)).norm(), 1e-8);
        EXPECT_LT((jet.v - (at(u, v + h).point - at(u, v - h).point) / (2 * h)).norm(), 1e-8);
        EXPECT_LT((jet.uu - (at(u + h, v).u - at(u - h, v).u) / (2 * h)).norm(), 1e-8);
        EXPECT_LT((jet.uv - (at(u, v + h).u - at(u, v - h).u) / (2 * h)).norm(), 1e-8);
        EXPECT_LT((jet.vv - (at(u, v + h).v - at(u, v - h).v) / (2 * h)).norm(), 1e-8);
    }
}

TEST(ClosedForms, PointsLieWhereTheirEquationsSay) {
    const Frame f = tilted();
    const auto local = [&](const Surface& s, double u, double v) -> Vector3d {
        const Vector3d d = evaluate(s, u, v).point - f.origin;
        return {d.dot(f.x), d.dot(f.y), d.dot(f.z)};
    };
    const Vector3d cylinder = local(Cylinder{f, 2.0}, 1.1, -0.6);
    EXPECT_NEAR(std::hypot(cylinder.x(), cylinder.y()), 2.0, 1e-14);
    const Vector3d sphere = local(Sphere{f, 3.0}, 2.2, 0.9);
    EXPECT_NEAR(sphere.norm(), 3.0, 1e-14);
    const Vector3d torus = local(Torus{f, 5.0, 1.25}, 4.0, 2.5);
    EXPECT_NEAR(std::hypot(std::hypot(torus.x(), torus.y()) - 5.0, torus.z()), 1.25, 1e-14);
    const Vector3d cone = local(Cone{f, 1.5, 0.3}, 4.0, 2.0);
    EXPECT_NEAR(std::hypot(cone.x(), cone.y()), 1.5 + cone.z() * std::tan(0.3), 1e-14);
}

TEST(ClosedForms, ParametersOfAPointGiveThePointBack) {
    for (const double scale : {1e-3, 1.0, 1e3}) {
        for (const Surface& s : closed_forms(scale)) {
            for (double u = -3.0; u < 3.1; u += 0.7) {
                for (double v = -1.2; v < 1.3; v += 0.4) {
                    const double length_u = s.index() == 0 ? scale : 1.0;  // the plane's u
                    const double length_v = s.index() <= 2 ? scale : 1.0;
                    const Vector3d p = evaluate(s, u * length_u, v * length_v).point;
                    const Vector2d uv = parameters_of(s, p);
                    EXPECT_LT((evaluate(s, uv.x(), uv.y()).point - p).norm(), 1e-14 * 20 * scale)
                        << kind_name(s);
                    EXPECT_LE(std::abs(uv.x()), kPi * length_u);
                }
            }
        }
    }
}

TEST(ClosedForms, NormalsOfRevolvedFormsPointAwayFromTheAxis) {
    for (const Surface& s : closed_forms(1.0)) {
        if (periodic_u(s)) {
            const SurfaceJet jet = evaluate(s, 0.3, 0.2);
            const Vector3d inside =
                tilted().origin + 5.0 * (std::cos(0.3) * tilted().x + std::sin(0.3) * tilted().y);
            const bool torus = std::holds_alternative<Torus>(s);
            const Vector3d outwards = jet.point - (torus ? inside : tilted().origin);
            EXPECT_GT(jet.u.cross(jet.v).dot(outwards), 0.0) << kind_name(s);
        }
    }
}

TEST(ParametersOf, IsNotForSplines) {
    EXPECT_THROW((void)parameters_of(SplineSurface{}, Vector3d::Zero()), ContractViolation);
}

/// The same point set in another parametrisation: turned about the axis, shifted along it, the axis
/// reversed where that is the same surface.
Surface disguised(const Surface& surface) {
    Surface other = surface;
    const auto turn = [](Frame& f, double angle, double sign) {
        const Vector3d x = std::cos(angle) * f.x + std::sin(angle) * f.y;
        f.x = x.normalized();
        f.z = sign * f.z;
        f.y = f.z.cross(f.x);
    };
    if (auto* p = std::get_if<Plane>(&other)) {
        p->frame.origin += 4.0 * p->frame.x - 7.0 * p->frame.y;
        turn(p->frame, 1.0, -1.0);
    } else if (auto* c = std::get_if<Cylinder>(&other)) {
        c->frame.origin += 6.0 * c->frame.z;
        turn(c->frame, 2.0, -1.0);
    } else if (auto* k = std::get_if<Cone>(&other)) {
        k->frame.origin += 0.5 * k->frame.z;
        k->radius += 0.5 * std::tan(k->half_angle);
        turn(k->frame, 0.4, -1.0);
        k->half_angle = -k->half_angle;
    } else if (auto* s = std::get_if<Sphere>(&other)) {
        turn(s->frame, 1.0, -1.0);
    } else if (auto* t = std::get_if<Torus>(&other)) {
        turn(t->frame, 1.0, -1.0);
    }
    return other;
}

TEST(SameSurface, RecognisesTheSamePointsInAnotherFrame) {
    for (const Surface& s : closed_forms(1.0)) {
        const Vector3d near = evaluate(s, 0.3, 0.2).point;
        EXPECT_TRUE(same_surface(s, disguised(s), near, 2.0, 1e-12)) << kind_name(s);
        EXPECT_TRUE(same_surface(disguised(s), s, near, 2.0, 1e-12)) << kind_name(s);
    }
}

TEST(SameSurface, TellsSurfacesApartThatDifferByMoreThanTheDistance) {
    for (const Surface& s : closed_forms(1.0)) {
        const Vector3d near = evaluate(s, 0.3, 0.2).point;
        Surface moved = s;
        std::visit(
            [&](auto& form) {
                if constexpr (!std::is_same_v<std::decay_t<decltype(form)>, SplineSurface>) {
                    form.frame.origin += 1e-4 * (form.frame.x + form.frame.z);
                }
            },
            moved);
        EXPECT_FALSE(same_surface(s, moved, near, 2.0, 1e-5)) << kind_name(s);
        EXPECT_TRUE(same_surface(s, moved, near, 2.0, 1e-3)) << kind_name(s);
    }
}

TEST(SameSurface, TellsTheTwoKindsOfEveryPairApart) {
    const auto forms = closed_forms(1.0);
    for (std::size_t i = 0; i < forms.size(); ++i) {
        for (std::size_t j = 0; j < forms.size(); ++j) {
            EXPECT_EQ(same_surface(forms[i], forms[j], Vector3d(3, -1, 2), 1.0, 1e-6), i == j);
        }
    }
}

}  // namespace
}  // namespace suture

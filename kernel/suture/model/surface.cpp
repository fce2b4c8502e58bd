#include "suture/model/surface.h"

#include "suture/base/contract.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace suture {
namespace {

using Eigen::Vector3d;

template <class... Ts>
struct Overloaded : Ts... {
    using Ts::operator()...;
};
template <class... Ts>
Overloaded(Ts...) -> Overloaded<Ts...>;  // clang 14 does not deduce it by itself

/// The frame of a closed form.
const Frame& frame_of(const Surface& surface) {
    static const Frame kWorld;
    return std::visit(Overloaded{[](const SplineSurface&) -> const Frame& { return kWorld; },
                                 [](const auto& form) -> const Frame& { return form.frame; }},
                      surface);
}

/// e(u) = cos u x + sin u y and its derivative.
struct Spoke {
    Vector3d e, t;
    Spoke(const Frame& frame, double u)
        : e(std::cos(u) * frame.x + std::sin(u) * frame.y),
          t(-std::sin(u) * frame.x + std::cos(u) * frame.y) {}
};

/// Jet of the surface of revolution origin + r(v) e(u) + h(v) z.
SurfaceJet revolve(const Frame& frame, double u, const Eigen::Array3d& r, const Eigen::Array3d& h) {
    const Spoke spoke(frame, u);
    return {frame.origin + r[0] * spoke.e + h[0] * frame.z,
            r[0] * spoke.t,
            r[1] * spoke.e + h[1] * frame.z,
            -r[0] * spoke.e,
            r[1] * spoke.t,
            r[2] * spoke.e + h[2] * frame.z};
}

/// How far the second axis strays from the first within `reach` of `near`.
double axis_distance(const Frame& a, const Frame& b, const Vector3d& near, double reach) {
    const double tilt = a.z.cross(b.z).norm();
    const Vector3d foot_a = a.origin + a.z * a.z.dot(near - a.origin);
    const Vector3d foot_b = b.origin + b.z * b.z.dot(foot_a - b.origin);
    return (foot_a - foot_b).norm() + tilt * reach;
}

/// How far points of b within `reach` of `near` may lie from a: an upper bound to first order.
double difference(const Plane& a, const Plane& b, const Vector3d& near, double reach) {
    const double tilt = a.frame.z.cross(b.frame.z).norm();
    const Vector3d foot = near - a.frame.z * a.frame.z.dot(near - a.frame.origin);
    return std::abs(b.frame.z.dot(foot - b.frame.origin)) + tilt * reach;
}

double difference(const Cylinder& a, const Cylinder& b, const Vector3d& near, double reach) {
    return axis_distance(a.frame, b.frame, near, reach) + std::abs(a.radius - b.radius);
}

double difference(const Cone& a, const Cone& b, const Vector3d& near, double reach) {
    // The same cone seen from two reference planes: compare the apex and the opening.
    const auto apex = [](const Cone& c) -> Vector3d {
        return c.frame.origin - c.frame.z * (c.radius / std::tan(c.half_angle));
    };
    const auto opening = [](const Cone& c) -> Vector3d {  // axis towards the growing radius
        return c.half_angle < 0.0 ? Vector3d(-c.frame.z) : c.frame.z;
    };
    const double tilt = (opening(a) - opening(b)).norm();
    const double spread = std::abs(std::abs(a.half_angle) - std::abs(b.half_angle));
    const double from_apex = (near - apex(a)).norm() + reach;
    return (apex(a) - apex(b)).norm() + (tilt + spread) * from_apex;
}

double difference(const Sphere& a, const Sphere& b, const Vector3d& /*near*/, double /*reach*/) {
    return (a.frame.origin - b.frame.origin).norm() + std::abs(a.radius - b.radius);
}

double difference(const Torus& a, const Torus& b, const Vector3d& /*near*/, double /*reach*/) {
    const double tilt = a.frame.z.cross(b.frame.z).norm();
    return (a.frame.origin - b.frame.origin).norm() + tilt * a.major + std::abs(a.major - b.major) +
           std::abs(a.minor - b.minor);
}

double difference(const SplineSurface& a, const SplineSurface& b, const Vector3d& /*near*/,
                  double /*reach*/) {
    const bool alike = a.degree_u == b.degree_u && a.degree_v == b.degree_v &&
                       a.knots_u == b.knots_u && a.knots_v == b.knots_v &&
                       a.weights.size() == b.weights.size() &&
                       (!a.rational() || a.weights == b.weights);
    return alike ? (a.poles - b.poles).colwise().norm().maxCoeff() : INFINITY;
}

}  // namespace

std::string_view kind_name(const Surface& surface) {
    constexpr std::string_view kNames[] = {"plane",  "cylinder", "cone",
                                           "sphere", "torus",    "B-spline surface"};
    return kNames[surface.index()];
}

bool periodic_u(const Surface& surface) {
    return !std::holds_alternative<Plane>(surface) &&
           !std::holds_alternative<SplineSurface>(surface);
}

bool periodic_v(const Surface& surface) {
    return std::holds_alternative<Torus>(surface);
}

SurfaceJet evaluate(const Surface& surface, double u, double v) {
    const double c = std::cos(v);
    const double s = std::sin(v);
    return std::visit(
        Overloaded{
            [&](const Plane& p) {
                const Vector3d zero = Vector3d::Zero();
                return SurfaceJet{p.frame.origin + u * p.frame.x + v * p.frame.y,
                                  p.frame.x,
                                  p.frame.y,
                                  zero,
                                  zero,
                                  zero};
            },
            [&](const Cylinder& p) {
                return revolve(p.frame, u, {p.radius, 0.0, 0.0}, {v, 1.0, 0.0});
            },
            [&](const Cone& p) {
                const double sa = std::sin(p.half_angle);
                const double ca = std::cos(p.half_angle);
                return revolve(p.frame, u, {p.radius + v * sa, sa, 0.0}, {v * ca, ca, 0.0});
            },
            [&](const Sphere& p) {
                const double r = p.radius;
                return revolve(p.frame, u, {r * c, -r * s, -r * c}, {r * s, r * c, -r * s});
            },
            [&](const Torus& p) {
                const double r = p.minor;
                return revolve(p.frame, u, {p.major + r * c, -r * s, -r * c},
                               {r * s, r * c, -r * s});
            },
            [&](const SplineSurface& p) { return evaluate(p, u, v); },
        },
        surface);
}

Eigen::Vector2d parameters_of(const Surface& surface, const Vector3d& point) {
    SUTURE_EXPECTS(!std::holds_alternative<SplineSurface>(surface));
    // Cylindrical coordinates in the surface's frame: angle, distance from the axis, height.
    const Frame& frame = frame_of(surface);
    const Vector3d d = point - frame.origin;
    const double x = d.dot(frame.x);
    const double y = d.dot(frame.y);
    const double r = std::hypot(x, y);
    const double h = d.dot(frame.z);
    const double u = std::atan2(y, x);
    return std::visit(
        Overloaded{
            [&](const Plane&) { return Eigen::Vector2d(x, y); },
            [&](const Cylinder&) { return Eigen::Vector2d(u, h); },
            [&](const Cone& p) {
                return Eigen::Vector2d(
                    u, (r - p.radius) * std::sin(p.half_angle) + h * std::cos(p.half_angle));
            },
            [&](const Sphere&) { return Eigen::Vector2d(u, std::atan2(h, r)); },
            [&](const Torus& p) { return Eigen::Vector2d(u, std::atan2(h, r - p.major)); },
            [&](const SplineSurface&) { return Eigen::Vector2d(x, y); },
        },
        surface);
}

bool same_surface(const Surface& a, const Surface& b, const Vector3d& near, double reach,
                  double distance) {
    return std::visit(
        [&](const auto& first) {
            using T = std::decay_t<decltype(first)>;
            const T* second = std::get_if<T>(&b);
            return second != nullptr && difference(first, *second, near, reach) <= distance;
        },
        a);
}

}  // namespace suture

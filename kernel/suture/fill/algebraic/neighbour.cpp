#include "suture/fill/algebraic/neighbour.h"

#include "suture/fill/algebraic/jets.h"

#include <Eigen/Geometry>
#include <Eigen/SVD>

#include <algorithm>
#include <array>
#include <cmath>
#include <type_traits>
#include <variant>

namespace suture::algebraic {
namespace {

using Eigen::Vector3d;
using Poly = Polynomial<double>;

/// Coordinates in a surface's own frame, in units of the hole.
std::array<Poly, 3> local(const Frame& frame, const Unit& unit) {
    const Vector3d o = unit.in(frame.origin);
    const auto along = [&](const Vector3d& axis) {
        return Poly::linear({axis.x(), axis.y(), axis.z()}, -axis.dot(o));
    };
    return {along(frame.x), along(frame.y), along(frame.z)};
}

Poly square(const Poly& p) {
    return p * p;
}

Poly form_of(const Plane& s, const Unit& unit) {
    return local(s.frame, unit)[2];
}
Poly form_of(const Cylinder& s, const Unit& unit) {
    const auto x = local(s.frame, unit);
    const double r = s.radius / unit.size;
    return square(x[0]) + square(x[1]) - Poly(r * r);
}
Poly form_of(const Cone& s, const Unit& unit) {
    const auto x = local(s.frame, unit);
    const Poly radius = Poly(s.radius / unit.size) + std::tan(s.half_angle) * x[2];
    return square(x[0]) + square(x[1]) - square(radius);
}
Poly form_of(const Sphere& s, const Unit& unit) {
    const auto x = local(s.frame, unit);
    const double r = s.radius / unit.size;
    return square(x[0]) + square(x[1]) + square(x[2]) - Poly(r * r);
}
Poly form_of(const Torus& s, const Unit& unit) {
    const auto x = local(s.frame, unit);
    const double R = s.major / unit.size;
    const double r = s.minor / unit.size;
    const Poly to_axis = square(x[0]) + square(x[1]);
    return square(to_axis + square(x[2]) + Poly(R * R - r * r)) - (4.0 * R * R) * to_axis;
}

}  // namespace

std::optional<Poly> equation_of(const Ribbon& ribbon, const Unit& unit) {
    if (!ribbon.support) {
        return std::nullopt;
    }
    std::optional<Poly> form = std::visit(
        [&](const auto& surface) -> std::optional<Poly> {
            if constexpr (std::is_same_v<std::decay_t<decltype(surface)>, SplineSurface>) {
                return std::nullopt;
            } else {
                return form_of(surface, unit);
            }
        },
        ribbon.support->surface);
    if (form) {
        const RibbonPoint middle = ribbon.at(0.5);
        const double slope = evaluate(*form, unit.in(middle.point)).gradient.dot(middle.normal);
        form = (slope < 0.0 ? -1.0 : 1.0) * *form;
    }
    return form;
}

SideShape shape_of(const Ribbon& ribbon, const Unit& unit, double distance) {
    constexpr int kSamples = 33;
    Eigen::Matrix3Xd points(3, kSamples);
    for (int n = 0; n < kSamples; ++n) {
        points.col(n) = unit.in(ribbon.at(static_cast<double>(n) / (kSamples - 1)).point);
    }
    const double limit = distance / unit.size;
    SideShape shape;
    const Vector3d chord = (points.col(kSamples - 1) - points.col(0)).normalized();
    double bend = 0.0;
    for (int n = 0; n < kSamples; ++n) {
        bend = std::max(bend, chord.cross(points.col(n) - points.col(0)).norm());
    }
    if (bend <= limit) {
        shape.straight = true;
        return shape;
    }
    const Vector3d mean = points.rowwise().mean();
    const Eigen::JacobiSVD<Eigen::MatrixXd> svd(points.colwise() - mean, Eigen::ComputeFullU);
    const Vector3d normal = svd.matrixU().col(2);
    if ((normal.transpose() * (points.colwise() - mean)).cwiseAbs().maxCoeff() <= limit) {
        shape.plane = Poly::linear({normal.x(), normal.y(), normal.z()}, -normal.dot(mean));
    }
    return shape;
}

}  // namespace suture::algebraic

#include "suture/fill/algebraic/neighbour.h"

#include "suture/fill/algebraic/jets.h"

#include <Eigen/Geometry>
#include <Eigen/SVD>

#include <algorithm>
#include <cmath>
#include <optional>

namespace suture::algebraic {
namespace {

using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;
using Poly = Polynomial<double>;

constexpr int kSamples = 33;

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

/// The plane or quadric through all points, if there is one. Distances are to first order, which is
/// right where they are small.
std::optional<Poly> recognise(const std::vector<Vector3d>& points, int degree, double distance) {
    MatrixXd A(static_cast<Eigen::Index>(points.size()), monomial_count(degree));
    for (std::size_t n = 0; n < points.size(); ++n) {
        A.row(static_cast<Eigen::Index>(n)) = monomial_jets(degree, points[n]).value;
    }
    const Eigen::BDCSVD<MatrixXd> svd(A, Eigen::ComputeThinV);
    const VectorXd c = svd.matrixV().rightCols(1);
    Poly form = Poly::zero(degree);
    std::copy(c.data(), c.data() + c.size(), form.coefficients.begin());
    for (const Vector3d& point : points) {
        const ValueAndGradient f = evaluate(form, point);
        if (!(std::abs(f.value) <= distance * f.gradient.norm())) {
            return std::nullopt;
        }
    }
    return form;
}

/// Points all over a B-spline's domain, which is where its pieces may differ.
std::vector<Vector3d> points_of(const SplineSurface& surface, const Unit& unit) {
    constexpr int kGrid = 16;
    const auto ends = [](const std::vector<double>& knots, int degree) {
        return std::pair(knots[static_cast<std::size_t>(degree)],
                         knots[knots.size() - static_cast<std::size_t>(degree) - 1]);
    };
    const auto [u0, u1] = ends(surface.knots_u, surface.degree_u);
    const auto [v0, v1] = ends(surface.knots_v, surface.degree_v);
    std::vector<Vector3d> points;
    for (int i = 0; i <= kGrid; ++i) {
        for (int j = 0; j <= kGrid; ++j) {
            points.push_back(unit.in(
                evaluate(surface, u0 + (u1 - u0) * i / kGrid, v0 + (v1 - v0) * j / kGrid).point));
        }
    }
    return points;
}

Result<Poly> recognised(const SplineSurface& surface, const Ribbon& ribbon, const Unit& unit,
                        double distance) {
    const std::vector<Vector3d> points = points_of(surface, unit);
    for (const int degree : {1, 2}) {
        if (const auto form = recognise(points, degree, distance / unit.size)) {
            return *form;
        }
    }
    return fail(ErrorCode::Refused,
                "{}: the neighbour is a B-spline surface that is no plane and no quadric to within "
                "{:.3g}",
                name_of(ribbon), distance);
}

}  // namespace

Result<Poly> implicit_form(const Ribbon& ribbon, const Unit& unit, double distance) {
    if (!ribbon.support) {
        return fail(ErrorCode::Refused, "{}: the neighbour lies on a surface without a closed form",
                    name_of(ribbon));
    }
    Result<Poly> form = std::visit(
        [&](const auto& surface) -> Result<Poly> {
            if constexpr (std::is_same_v<std::decay_t<decltype(surface)>, SplineSurface>) {
                return recognised(surface, ribbon, unit, distance);
            } else {
                return form_of(surface, unit);
            }
        },
        ribbon.support->surface);
    if (!form) {
        return form;
    }
    constexpr double kLeastGradient = 1e-9;
    const RibbonPoint middle = ribbon.at(0.5);
    const double slope = evaluate(*form, unit.in(middle.point)).gradient.dot(middle.normal);
    if (std::abs(slope) < kLeastGradient) {
        return fail(ErrorCode::Refused, "{}: the neighbour is singular there", name_of(ribbon));
    }
    return (1.0 / slope) * *form;
}

Result<SideShape> shape_of(const Ribbon& ribbon, const Unit& unit, double distance) {
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
    const Eigen::JacobiSVD<MatrixXd> svd(points.colwise() - mean, Eigen::ComputeFullU);
    const Vector3d normal = svd.matrixU().col(2);
    const double off = (normal.transpose() * (points.colwise() - mean)).cwiseAbs().maxCoeff();
    if (off > limit) {
        return fail(ErrorCode::Refused,
                    "{} is not planar: it leaves its nearest plane by {:.3g}, more than {:.3g}",
                    name_of(ribbon), off * unit.size, distance);
    }
    shape.plane = Poly::linear({normal.x(), normal.y(), normal.z()}, -normal.dot(mean));
    return shape;
}

}  // namespace suture::algebraic

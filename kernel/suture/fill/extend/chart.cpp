#include "suture/fill/extend/chart.h"

#include "suture/base/tolerance.h"

#include <Eigen/Geometry>

#include <cmath>

namespace suture::extend {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

/// Weights at both ends of a closed B-spline that differ by rounding only.
constexpr double kSameWeight = 1e-12;

/// A ribbon that ends in a pole may miss it by this share of the hole's size, of its own length, of
/// the sphere's radius or of the B-spline's domain: ten times what files round.
constexpr double kInPole = 1e-8;

double first_knot(const std::vector<double>& knots, int degree) {
    return knots[static_cast<std::size_t>(degree)];
}
double last_knot(const std::vector<double>& knots, int count) {
    return knots[static_cast<std::size_t>(count)];
}

/// A B-spline seen along one coordinate: 0 = u, 1 = v.
struct Along {
    const SplineSurface& spline;
    int coordinate;
    double distance;

    [[nodiscard]] int count() const {
        return coordinate == 0 ? spline.count_u() : spline.count_v();
    }
    [[nodiscard]] int rows() const { return coordinate == 0 ? spline.count_v() : spline.count_u(); }
    [[nodiscard]] int index(int i, int row) const {
        return coordinate == 0 ? spline.index(i, row) : spline.index(row, i);
    }
    [[nodiscard]] double begin() const {
        return coordinate == 0 ? first_knot(spline.knots_u, spline.degree_u)
                               : first_knot(spline.knots_v, spline.degree_v);
    }
    [[nodiscard]] double end() const {
        return coordinate == 0 ? last_knot(spline.knots_u, count())
                               : last_knot(spline.knots_v, count());
    }
    [[nodiscard]] bool closed() const {
        for (int row = 0; row < rows(); ++row) {
            const int a = index(0, row);
            const int b = index(count() - 1, row);
            if ((spline.poles.col(a) - spline.poles.col(b)).norm() > distance ||
                (spline.rational() && std::abs(spline.weights[a] - spline.weights[b]) >
                                          kSameWeight * spline.weights[a])) {
                return false;
            }
        }
        return true;
    }
    /// The border at i = 0 or count() - 1 is one point.
    [[nodiscard]] bool collapsed(int i) const {
        for (int row = 1; row < rows(); ++row) {
            if ((spline.poles.col(index(i, row)) - spline.poles.col(index(i, 0))).norm() >
                distance) {
                return false;
            }
        }
        return true;
    }
};

/// Distance of a point from the axis of a cone or sphere; infinite for all other surfaces.
double from_axis(const Surface& surface, const Vector3d& point) {
    const auto distance = [&](const Frame& frame) {
        return frame.z.cross(point - frame.origin).norm();
    };
    if (const auto* cone = std::get_if<Cone>(&surface)) {
        return distance(cone->frame);
    }
    if (const auto* sphere = std::get_if<Sphere>(&surface)) {
        return distance(sphere->frame);
    }
    return INFINITY;
}

}  // namespace

Vector2d own_parameters(const Ribbon& ribbon, double s) {
    return ribbon.support->uv(s);
}

Vector2d Chart::uv(const Ribbon& ribbon, double s) const {
    if (std::holds_alternative<SplineSurface>(surface)) {
        return locate(ribbon, s);
    }
    const RibbonPoint p = ribbon.at(s);
    Vector2d result = parameters_of(surface, p.point);
    const double length = p.tangent.norm();
    if (from_axis(surface, p.point) < kInPole * length) {
        const Vector3d beside = p.point + (s < 0.5 ? 1.0 : -1.0) * p.tangent;
        result.x() = parameters_of(surface, beside).x();
    }
    return result;
}

const Pole* Chart::pole_at(const Vector2d& at) const {
    for (const Pole& pole : poles) {
        if (std::abs(at[pole.across] - pole.value) <= pole.slack) {
            return &pole;
        }
    }
    return nullptr;
}

Chart chart_of(const Surface& surface, double distance, double reach) {
    Chart chart;
    chart.surface = surface;
    if (const auto* spline = std::get_if<SplineSurface>(&surface)) {
        for (const int c : {0, 1}) {
            const Along along{*spline, c, distance};
            chart.period[c] = along.closed() ? along.end() - along.begin() : 0.0;
            const double slack = kInPole * (along.end() - along.begin());
            if (along.collapsed(0)) {
                chart.poles.push_back({c, along.begin(), -1.0, slack});
            }
            if (along.collapsed(along.count() - 1)) {
                chart.poles.push_back({c, along.end(), 1.0, slack});
            }
        }
        return chart;
    }
    chart.period = {periodic_u(surface) ? 2.0 * kPi : 0.0, periodic_v(surface) ? 2.0 * kPi : 0.0};
    if (std::holds_alternative<Sphere>(surface)) {
        chart.poles = {{1, -kPi / 2.0, -1.0, kInPole}, {1, kPi / 2.0, 1.0, kInPole}};
    }
    if (const auto* cone = std::get_if<Cone>(&surface)) {
        // The half on which the radius is positive.
        const double sine = std::sin(cone->half_angle);
        chart.poles = {{1, -cone->radius / sine, sine > 0.0 ? -1.0 : 1.0, kInPole * reach}};
    }
    return chart;
}

Vector2d nearest(const Vector2d& value, const Vector2d& centre, const Vector2d& period) {
    Vector2d result = value;
    for (const int c : {0, 1}) {
        if (period[c] > 0.0) {
            result[c] = centre[c] + std::remainder(value[c] - centre[c], period[c]);
        }
    }
    return result;
}

}  // namespace suture::extend

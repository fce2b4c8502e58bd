#include "suture/faces/foot_points.h"

#include "suture/occ/convert.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>

namespace suture {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using occ::Handle;

/// Newton's steps, which double the digits: more are of no use where the foot is near.
constexpr int kSteps = 12;

/// A step that moves the foot by less than this share of its distance from the origin is rounding.
constexpr double kArrived = 1e-15;

/// Newton's steps go nearer, but for rounding.
constexpr double kFarther = 1.0 + 1e-9;

/// Where the two directions of a surface are this much alike, it is singular.
constexpr double kSingular = 1e-12;

/// Within this share of the domain a point lies on its border.
constexpr double kOnBorder = 1e-12;

/// Away from an end its correction falls like a power: gone within a fifth of the edge.
constexpr int kFall = 16;

/// How far (u, v) may go in one direction, from where it started.
struct Room {
    double low = 0.0, high = 0.0;

    Room(double at, double from, double to, bool endless) : low(from), high(to) {
        if (endless) {
            low = at - (to - from);
            high = at + (to - from);
            return;
        }
        const double border = kOnBorder * (to - from);
        if (at <= from + border || at >= to - border) {
            low = high = at;  // on the border, or what a layout has beyond: it slides along
        }
    }
};

std::array<Room, 2> room_about(const Vector2d& about, const Geom_Surface& surface) {
    double u0 = 0.0;
    double u1 = 0.0;
    double v0 = 0.0;
    double v1 = 0.0;
    surface.Bounds(u0, u1, v0, v1);
    return {Room(about.x(), u0, u1, surface.IsUPeriodic()),
            Room(about.y(), v0, v1, surface.IsVPeriodic())};
}

/// The step towards the foot; components without room stay.
Vector2d step_to_foot(const Vector3d& miss, const std::array<Vector3d, 5>& d,
                      const std::array<Room, 2>& room) {
    const auto& [u, v, uu, vv, uv] = d;  // in the order of Geom_Surface::D2
    Eigen::Matrix2d metric;
    metric << u.dot(u), u.dot(v), u.dot(v), v.dot(v);
    Eigen::Matrix2d hessian;
    hessian << miss.dot(uu), miss.dot(uv), miss.dot(uv), miss.dot(vv);
    hessian = metric - hessian;
    Vector2d slope(miss.dot(u), miss.dot(v));
    for (int k = 0; k < 2; ++k) {
        if (room[static_cast<std::size_t>(k)].low == room[static_cast<std::size_t>(k)].high) {
            slope[k] = 0.0;
            for (Eigen::Matrix2d* matrix : {&metric, &hessian}) {
                (*matrix)(k, 1 - k) = (*matrix)(1 - k, k) = 0.0;
                (*matrix)(k, k) = 1.0;
            }
        }
    }
    const auto singular = [](const Eigen::Matrix2d& matrix) {
        return matrix.determinant() <= kSingular * matrix(0, 0) * matrix(1, 1);
    };
    if (singular(metric)) {
        return Vector2d::Zero();
    }
    return (singular(hessian) ? metric : hessian).inverse() * slope;
}

}  // namespace

Vector2d foot_point(const Vector3d& point, const Geom_Surface& surface, const Vector2d& about) {
    const std::array<Room, 2> room = room_about(about, surface);
    Vector2d best = about;
    double nearest = -1.0;
    Vector2d uv = about;
    for (int k = 0; k < kSteps; ++k) {
        gp_Pnt at;
        std::array<gp_Vec, 5> d;
        surface.D2(uv.x(), uv.y(), at, d[0], d[1], d[2], d[3], d[4]);
        const Vector3d miss = point - occ::from_occ(at);
        if (nearest >= 0.0 && miss.norm() > kFarther * nearest) {
            break;
        }
        nearest = miss.norm();
        best = uv;
        const std::array<Vector3d, 5> slopes{occ::from_occ(d[0]), occ::from_occ(d[1]),
                                             occ::from_occ(d[2]), occ::from_occ(d[3]),
                                             occ::from_occ(d[4])};
        const Vector2d step = step_to_foot(miss, slopes, room);
        const double moved = (slopes[0] * step.x() + slopes[1] * step.y()).norm();
        if (moved <= kArrived * point.norm()) {
            break;
        }
        uv += step;
        uv.x() = std::clamp(uv.x(), room[0].low, room[0].high);
        uv.y() = std::clamp(uv.y(), room[1].low, room[1].high);
    }
    return best;
}

std::function<Vector2d(double)> foot_points(const Handle<Geom_Curve>& curve, double first,
                                            double last, const Handle<Geom_Surface>& surface,
                                            std::function<Vector2d(double)> about,
                                            const std::array<Vector2d, 2>& ends) {
    const auto foot = [curve, surface, about](double t) {
        return foot_point(occ::from_occ(curve->Value(t)), *surface, about(t));
    };
    const Vector2d at_first = ends[0] - foot(first);
    const Vector2d at_last = ends[1] - foot(last);
    return [=](double t) -> Vector2d {
        const double s = std::clamp((t - first) / (last - first), 0.0, 1.0);
        return foot(t) + std::pow(1.0 - s, kFall) * at_first + std::pow(s, kFall) * at_last;
    };
}

}  // namespace suture

#include "suture/fill/extend/sphere_frame.h"

#include "suture/base/tolerance.h"
#include "suture/fill/extend/region.h"
#include "suture/fill/extend/trace.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <optional>

namespace suture::extend {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

/// Sides that keep this far away from the poles are far enough: 10 degrees keeps the
/// parametrisation within a factor of six.
constexpr double kPoleDistance = radians(10.0);

/// Axes tried at right angles to the middle of the loops.
constexpr int kTries = 36;

constexpr int kSamples = 32;

/// A side that leaves a meridian or a circle of latitude by less than this, in radians, is one.
constexpr double kOnLine = 1e-10;

/// Directions from the centre to the sides, loop by loop, side by side.
using Directions = std::vector<std::vector<std::vector<Vector3d>>>;

Directions directions_of(const Sphere& sphere, const Hole& hole) {
    Directions result;
    for (const RibbonLoop& loop : hole.loops) {
        auto& sides = result.emplace_back();
        for (const Ribbon& ribbon : loop.ribbons) {
            auto& side = sides.emplace_back();
            for (int k = 0; k <= kSamples; ++k) {
                const Vector3d p = ribbon.at(static_cast<double>(k) / kSamples).point;
                side.push_back((p - sphere.frame.origin).normalized());
            }
        }
    }
    return result;
}

/// The mean direction of a loop, weighted by length.
Vector3d middle_of(const std::vector<std::vector<Vector3d>>& sides) {
    Vector3d sum = Vector3d::Zero();
    for (const auto& side : sides) {
        for (std::size_t k = 1; k < side.size(); ++k) {
            sum += (side[k] - side[k - 1]).norm() * (side[k] + side[k - 1]);
        }
    }
    return sum;
}

/// The axis of the circle in which a side lies, if it lies in one.
Vector3d circle_axis(const std::vector<Vector3d>& side) {
    Vector3d mean = Vector3d::Zero();
    for (const Vector3d& d : side) {
        mean += d / static_cast<double>(side.size());
    }
    Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
    for (const Vector3d& d : side) {
        spread += (d - mean) * (d - mean).transpose();
    }
    return Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(spread).eigenvectors().col(0);
}

std::vector<Vector3d> axes_to_try(const Sphere& sphere, const Directions& directions) {
    std::vector<Vector3d> axes = {sphere.frame.z};
    for (const auto& loop : directions) {
        for (const auto& side : loop) {
            axes.push_back(circle_axis(side));
        }
    }
    Vector3d all = Vector3d::Zero();
    std::vector<Vector3d> middles;
    for (const auto& loop : directions) {
        middles.push_back(middle_of(loop));
        all += middles.back();
        const double size = middles.back().norm();
        if (size > 0.0) {
            middles.back() /= size;
            axes.push_back(middles.back());
        }
    }
    for (std::size_t i = 0; i < middles.size(); ++i) {
        for (std::size_t j = i + 1; j < middles.size(); ++j) {
            const Vector3d between = middles[i] - middles[j];
            if (between.norm() > kPoleDistance) {
                axes.push_back(between.normalized());
            }
        }
    }
    const double size = all.norm();
    const Vector3d middle = size > 0.0 ? Vector3d(all / size) : sphere.frame.x;
    const Vector3d a = middle.unitOrthogonal();
    const Vector3d b = middle.cross(a);
    for (int k = 0; k < kTries; ++k) {
        const double angle = kPi * k / kTries;
        axes.emplace_back(std::cos(angle) * a + std::sin(angle) * b);
    }
    return axes;
}

/// The frame with this axis, turned as little as possible.
Frame with_axis(const Frame& own, const Vector3d& z) {
    Frame frame = own;
    frame.z = z;
    const Vector3d x = own.x - z * z.dot(own.x);
    frame.x = x.norm() > 0.5 ? x.normalized() : z.cross(own.y).normalized();
    frame.y = z.cross(frame.x);
    return frame;
}

/// Whether a side is a line of the domain: files hold it in a few bytes, and readers exactly.
bool is_line(const Frame& frame, const std::vector<Vector3d>& side) {
    const Vector3d& mid = side[side.size() / 2];
    const Vector3d across = frame.z.cross(mid).normalized();
    double leaves_meridian = 0.0;
    double leaves_latitude = 0.0;
    for (const Vector3d& d : side) {
        leaves_meridian = std::max(leaves_meridian, std::abs(across.dot(d)));
        leaves_latitude = std::max(leaves_latitude, std::abs((d - mid).dot(frame.z)));
    }
    return std::min(leaves_meridian, leaves_latitude) < kOnLine;
}

bool all_lines(const Frame& frame, const Directions& directions) {
    return std::ranges::all_of(directions, [&](const auto& loop) {
        return std::ranges::all_of(loop, [&](const auto& side) { return is_line(frame, side); });
    });
}

/// How good a frame is; nothing: the hole cannot be written in it.
std::optional<double> worth(const Chart& chart, const Directions& directions, bool reversed) {
    const Frame& frame = std::get<Sphere>(chart.surface).frame;
    double distance = INFINITY;
    std::vector<Trace> traces;
    for (const auto& loop : directions) {
        Samples samples;
        for (const auto& side : loop) {
            auto& row = samples.emplace_back();
            for (const Vector3d& d : side) {
                const double height = std::asin(std::clamp(d.dot(frame.z), -1.0, 1.0));
                row.emplace_back(std::atan2(d.dot(frame.y), d.dot(frame.x)), height);
                distance = std::min(distance, kPi / 2.0 - std::abs(height));
            }
        }
        traces.push_back(unwrap(chart, samples, reversed));
    }
    const auto region = region_of(chart, traces, reversed);
    if (!region) {
        return std::nullopt;
    }
    // A disc of lines may have a pole in its corner, as CAD systems have it. Else first enough
    // distance, then the simplest region, then more distance.
    if (region->kind == Region::Kind::Disc && all_lines(frame, directions)) {
        return 200.0;
    }
    const double enough = std::min(distance / kPoleDistance, 1.0);
    return 100.0 * enough - static_cast<double>(region->kind) + 0.1 * distance;
}

}  // namespace

Frame sphere_frame(const Sphere& sphere, const Hole& hole, bool reversed) {
    const Directions directions = directions_of(sphere, hole);
    Frame best = sphere.frame;
    std::optional<double> most;
    for (const Vector3d& z : axes_to_try(sphere, directions)) {
        Sphere turned = sphere;
        turned.frame = with_axis(sphere.frame, z);
        const auto value = worth(chart_of(turned, 0.0, 0.0), directions, reversed);
        const bool own = most && best.z == sphere.frame.z;
        // The neighbour's own frame is kept unless another is better in kind.
        if (value && (!most || *value > *most + (own ? 0.5 : 0.0))) {
            most = value;
            best = turned.frame;
        }
    }
    return best;
}

}  // namespace suture::extend

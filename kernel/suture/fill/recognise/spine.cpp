#include "suture/fill/recognise/spine.h"

#include <Eigen/Geometry>
#include <Eigen/QR>

#include <algorithm>
#include <cmath>

namespace suture::recognise {
namespace {

using Eigen::Matrix4d;
using Eigen::Vector2d;
using Eigen::Vector3d;
using Eigen::Vector4d;

constexpr int kSteps = 20;
/// Pivots below this share are none: on a plane or a cylinder a contact moves freely.
constexpr double kRank = 1e-9;
/// The two centres agree to this share of the radius.
constexpr double kAgree = 1e-9;
constexpr std::size_t kMostPositions = 600;
/// Two surfaces whose normals are nearly the same, or opposite, hold no ball.
constexpr double kLeastAngle = 1e-3;
/// Where the path ends at less than this between the normals, it ends where they meet.
constexpr double kRunsOut = 0.05;

}  // namespace

RollingBall::Contact RollingBall::contact(int which, const Vector2d& uv) const {
    const Support& support = *support_[which];
    const SurfaceJet jet = evaluate(support.surface, uv.x(), uv.y());
    const double sign = support.reversed ? -1.0 : 1.0;
    const Vector3d m = jet.u.cross(jet.v);
    const double size = m.norm();
    Contact result;
    result.normal = sign * m / size;
    result.centre = jet.point - r_ * result.normal;
    const auto turned = [&](const Vector3d& dm) -> Vector3d {
        return sign * (dm - m * m.dot(dm) / (size * size)) / size;
    };
    result.by_uv.col(0) = jet.u - r_ * turned(jet.uu.cross(jet.v) + jet.u.cross(jet.uv));
    result.by_uv.col(1) = jet.v - r_ * turned(jet.uv.cross(jet.v) + jet.u.cross(jet.vv));
    return result;
}

BallPosition RollingBall::position(const Vector2d& uv1, const Vector2d& uv2) const {
    BallPosition result;
    const Contact a = contact(0, uv1);
    const Contact b = contact(1, uv2);
    result.centre = 0.5 * (a.centre + b.centre);
    result.normal[0] = a.normal;
    result.normal[1] = b.normal;
    result.tangent = a.normal.cross(b.normal).normalized();
    result.uv[0] = uv1;
    result.uv[1] = uv2;
    return result;
}

std::optional<BallPosition> RollingBall::at(const Vector3d& centre,
                                            const BallPosition& start) const {
    Vector2d uv1 = start.uv[0];
    Vector2d uv2 = start.uv[1];
    double last = INFINITY;
    for (int step = 0; step < kSteps; ++step) {
        const Contact a = contact(0, uv1);
        const Contact b = contact(1, uv2);
        Vector4d f;
        f << a.centre - b.centre, start.tangent.dot(a.centre - centre);
        Matrix4d J;
        J << a.by_uv, -b.by_uv, start.tangent.transpose() * a.by_uv, 0.0, 0.0;
        const double size = f.norm();
        if (!std::isfinite(size)) {
            return std::nullopt;
        }
        if (size < kAgree * std::abs(r_) && !(size < 0.5 * last)) {
            const bool bent = a.normal.cross(b.normal).norm() > kLeastAngle;
            return bent ? std::optional(position(uv1, uv2)) : std::nullopt;
        }
        last = size;
        Eigen::CompleteOrthogonalDecomposition<Matrix4d> shortest;
        shortest.setThreshold(kRank);
        const Vector4d x = shortest.compute(J).solve(-f);
        uv1 += x.head<2>();
        uv2 += x.tail<2>();
    }
    return std::nullopt;
}

std::optional<BallPosition> RollingBall::near(const Vector2d& uv1, const Vector2d& uv2) const {
    const BallPosition start = position(uv1, uv2);
    return start.tangent.allFinite() ? at(start.centre, start) : std::nullopt;
}

namespace {

/// Which of the positions is nearest to each point; whether that is an end for one of them.
struct Ends {
    bool front = false;
    bool back = false;
};

Ends needs_more(const std::vector<BallPosition>& path, const Eigen::Matrix3Xd& cover) {
    Ends ends;
    const auto beyond = [](const BallPosition& p, const Vector3d& point, double way) {
        return way * p.tangent.dot(point - p.centre) > 0.0;
    };
    for (Eigen::Index k = 0; k < cover.cols(); ++k) {
        const Vector3d point = cover.col(k);
        std::size_t nearest = 0;
        for (std::size_t i = 1; i < path.size(); ++i) {
            if ((path[i].centre - point).squaredNorm() <
                (path[nearest].centre - point).squaredNorm()) {
                nearest = i;
            }
        }
        ends.front = ends.front || (nearest == 0 && beyond(path.front(), point, -1.0));
        ends.back = ends.back || (nearest + 1 == path.size() && beyond(path.back(), point, 1.0));
    }
    return ends;
}

/// Whether the two surfaces are so nearly tangent to each other there that the path ends: the
/// corner of a hole at which the two sides meet.
bool runs_out(const BallPosition& p) {
    return p.normal[0].cross(p.normal[1]).norm() < kRunsOut && p.normal[0].dot(p.normal[1]) > 0.0;
}

std::optional<BallPosition> next(const RollingBall& ball, const BallPosition& from, double step) {
    for (int halving = 0; halving < 3; ++halving, step *= 0.5) {
        auto found = ball.at(from.centre + step * from.tangent, from);
        if (found && found->tangent.dot(from.tangent) > 0.5) {
            return found;
        }
    }
    return std::nullopt;
}

}  // namespace

Result<std::vector<BallPosition>> walk(const RollingBall& ball, const BallPosition& start,
                                       double step, const Eigen::Matrix3Xd& cover) {
    std::vector<BallPosition> path = {start};
    Ends out;  // where the path runs out
    while (true) {
        const Ends needs = needs_more(path, cover);
        const Ends ends{needs.front && !out.front, needs.back && !out.back};
        if (!ends.front && !ends.back) {
            return path;
        }
        if (path.size() > kMostPositions) {
            return fail(ErrorCode::Refused, "the rolling ball's path does not end");
        }
        if (ends.back) {
            const auto found = next(ball, path.back(), step);
            out.back = !found && runs_out(path.back());
            if (!found && !out.back) {
                return fail(ErrorCode::Refused, "the rolling ball's path ends inside of the hole");
            }
            if (found) {
                path.push_back(*found);
            }
        }
        if (ends.front) {
            const auto found = next(ball, path.front(), -step);
            out.front = !found && runs_out(path.front());
            if (!found && !out.front) {
                return fail(ErrorCode::Refused, "the rolling ball's path ends inside of the hole");
            }
            if (found) {
                path.insert(path.begin(), *found);
            }
        }
    }
}

}  // namespace suture::recognise

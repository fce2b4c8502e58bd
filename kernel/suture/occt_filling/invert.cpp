#include "suture/occt_filling/invert.h"

#include "suture/fill/mvs/polygon.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>

namespace suture {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

/// Samples along each side by which its curve is judged.
constexpr int kSamples = 48;

constexpr int kNewtonSteps = 30;
constexpr int kHalvings = 20;

/// Newton has arrived when a step moves by less than this fraction of the domain.
constexpr double kArrived = 1e-14;

/// A step may lead this much farther from the target, relatively: rounding.
constexpr double kRounding = 1.0 + 1e-6;

/// Between two samples a curve that goes on smoothly moves by less than this fraction of the
/// domain, even if it is all of the loop.
constexpr double kJump = 0.2;

struct Domain {
    Vector2d low, high;

    explicit Domain(const SplineSurface& s)
        : low(s.knots_u[static_cast<std::size_t>(s.degree_u)],
              s.knots_v[static_cast<std::size_t>(s.degree_v)]),
          high(s.knots_u[static_cast<std::size_t>(s.count_u())],
               s.knots_v[static_cast<std::size_t>(s.count_v())]) {}

    [[nodiscard]] double size() const { return (high - low).norm(); }
};

/// Gauss-Newton, never away from the target: the surface passes near it, so the curvature term
/// hardly matters.
Vector2d refine(const SplineSurface& surface, const Domain& domain, const Vector3d& target,
                const Vector2d& guess) {
    Vector2d uv = guess.cwiseMax(domain.low).cwiseMin(domain.high);
    SurfaceJet jet = evaluate(surface, uv.x(), uv.y());
    for (int step = 0; step < kNewtonSteps; ++step) {
        Eigen::Matrix<double, 3, 2> J;
        J << jet.u, jet.v;
        Vector2d move = (J.transpose() * J).inverse() * (J.transpose() * (target - jet.point));
        if (!move.allFinite()) {
            return uv;
        }
        const double distance = (jet.point - target).norm();
        Vector2d next;
        int halvings = 0;
        for (;; move *= 0.5) {
            next = (uv + move).cwiseMax(domain.low).cwiseMin(domain.high);
            jet = evaluate(surface, next.x(), next.y());
            if ((jet.point - target).norm() <= kRounding * distance) {
                break;
            }
            if (++halvings > kHalvings) {
                return uv;
            }
        }
        const double moved = (next - uv).norm();
        uv = next;
        if (moved < kArrived * domain.size()) {
            break;
        }
    }
    return uv;
}

/// The loop's samples, 2 x count.
Eigen::Matrix2Xd polygon_of(const std::vector<TrimCurve>& loop) {
    Eigen::Matrix2Xd polygon(2, static_cast<Eigen::Index>(loop.size()) * kSamples);
    Eigen::Index next = 0;
    for (const TrimCurve& side : loop) {
        for (int k = 0; k < kSamples; ++k) {
            polygon.col(next++) = side(static_cast<double>(k) / kSamples);
        }
    }
    return polygon;
}

bool is_simple(const std::vector<TrimCurve>& loop, const Domain& domain) {
    const Eigen::Matrix2Xd polygon = polygon_of(loop);
    for (Eigen::Index i = 0; i < polygon.cols(); ++i) {
        const Vector2d step = polygon.col((i + 1) % polygon.cols()) - polygon.col(i);
        if (step.norm() > kJump * domain.size()) {
            return false;
        }
    }
    return !mvs::crosses_itself(polygon);
}

}  // namespace

std::vector<TrimCurve> invert_boundary(const std::shared_ptr<const SplineSurface>& surface,
                                       const RibbonLoop& loop,
                                       const std::vector<TrimCurve>& guesses) {
    const Domain domain(*surface);
    std::vector<TrimCurve> nearest;
    for (std::size_t i = 0; i < loop.ribbons.size(); ++i) {
        nearest.emplace_back(
            [surface, domain, at = loop.ribbons[i].at, guess = guesses[i]](double s) {
                return refine(*surface, domain, at(s).point, guess(s));
            });
    }
    return is_simple(nearest, domain) ? nearest : guesses;
}

double signed_area(const std::vector<TrimCurve>& loop) {
    const Eigen::Matrix2Xd polygon = polygon_of(loop);
    double twice = 0.0;
    for (Eigen::Index i = 0; i < polygon.cols(); ++i) {
        const Vector2d a = polygon.col(i);
        const Vector2d b = polygon.col((i + 1) % polygon.cols());
        twice += a.x() * b.y() - a.y() * b.x();
    }
    return 0.5 * twice;
}

}  // namespace suture

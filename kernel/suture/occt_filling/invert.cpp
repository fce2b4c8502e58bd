#include "suture/occt_filling/invert.h"

#include <Eigen/LU>

#include <cmath>

namespace suture {
namespace {

using Eigen::Matrix2d;
using Eigen::Vector2d;
using Eigen::Vector3d;

/// Points per direction of the grid from which the first point of a loop is sought.
constexpr int kGrid = 33;

/// Steps along each side: short against the surface's spans, so that Newton starts near enough.
constexpr int kSteps = 48;

constexpr int kNewtonSteps = 12;

/// Newton has arrived when a step moves by less than this fraction of the domain.
constexpr double kArrived = 1e-14;

/// Samples per side for an area whose sign is wanted.
constexpr int kAreaSamples = 32;

struct Domain {
    Vector2d low, high;

    explicit Domain(const SplineSurface& s)
        : low(s.knots_u[static_cast<std::size_t>(s.degree_u)],
              s.knots_v[static_cast<std::size_t>(s.degree_v)]),
          high(s.knots_u[static_cast<std::size_t>(s.count_u())],
               s.knots_v[static_cast<std::size_t>(s.count_v())]) {}
};

Vector2d nearest_of_grid(const SplineSurface& surface, const Domain& domain,
                         const Vector3d& target) {
    Vector2d best = domain.low;
    double least = INFINITY;
    for (int j = 0; j < kGrid; ++j) {
        for (int i = 0; i < kGrid; ++i) {
            const Vector2d fraction(i / (kGrid - 1.0), j / (kGrid - 1.0));
            const Vector2d uv = domain.low + (domain.high - domain.low).cwiseProduct(fraction);
            const double d = (evaluate(surface, uv.x(), uv.y()).point - target).norm();
            if (d < least) {
                least = d;
                best = uv;
            }
        }
    }
    return best;
}

/// Gauss-Newton: the surface passes near the target, so the curvature term hardly matters.
Vector2d refine(const SplineSurface& surface, const Domain& domain, const Vector3d& target,
                Vector2d uv) {
    const double size = (domain.high - domain.low).norm();
    for (int step = 0; step < kNewtonSteps; ++step) {
        const SurfaceJet jet = evaluate(surface, uv.x(), uv.y());
        Eigen::Matrix<double, 3, 2> J;
        J << jet.u, jet.v;
        const Matrix2d normal = J.transpose() * J;
        const Vector2d move = normal.inverse() * (J.transpose() * (target - jet.point));
        if (!move.allFinite()) {
            return uv;
        }
        uv = (uv + move).cwiseMax(domain.low).cwiseMin(domain.high);
        if (move.norm() < kArrived * size) {
            break;
        }
    }
    return uv;
}

}  // namespace

std::vector<std::vector<TrimCurve>> invert_boundary(
    const std::shared_ptr<const SplineSurface>& surface, const Hole& hole) {
    const Domain domain(*surface);
    std::vector<std::vector<TrimCurve>> trims;
    for (const RibbonLoop& loop : hole.loops) {
        auto& row = trims.emplace_back();
        Vector2d uv = nearest_of_grid(*surface, domain, loop.ribbons.front().at(0.0).point);
        for (const Ribbon& ribbon : loop.ribbons) {
            std::vector<Vector2d> walked;
            for (int k = 0; k <= kSteps; ++k) {
                const double s = static_cast<double>(k) / kSteps;
                uv = refine(*surface, domain, ribbon.at(s).point, uv);
                walked.push_back(uv);
            }
            row.emplace_back([surface, domain, at = ribbon.at, walked](double s) {
                const double place = std::clamp(s, 0.0, 1.0) * kSteps;
                const int k = std::min(static_cast<int>(place), kSteps - 1);
                const auto cell = static_cast<std::size_t>(k);
                const Vector2d guess =
                    walked[cell] + (walked[cell + 1] - walked[cell]) * (place - k);
                return refine(*surface, domain, at(s).point, guess);
            });
        }
    }
    return trims;
}

double signed_area(const std::vector<TrimCurve>& loop) {
    std::vector<Vector2d> polygon;
    for (const TrimCurve& side : loop) {
        for (int k = 0; k < kAreaSamples; ++k) {
            polygon.push_back(side(static_cast<double>(k) / kAreaSamples));
        }
    }
    double twice = 0.0;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Vector2d& a = polygon[i];
        const Vector2d& b = polygon[(i + 1) % polygon.size()];
        twice += a.x() * b.y() - a.y() * b.x();
    }
    return 0.5 * twice;
}

}  // namespace suture

#include "suture/fill/mvs/domain.h"

#include "suture/fill/mvs/chebyshev.h"

#include <Eigen/Cholesky>

#include <limits>

namespace suture::mvs {
namespace {

// Points on a side of an island.
constexpr int kIslandPoints = 33;
// Feet are sought from a grid of so many points a span, and found when they move less than this.
constexpr int kGridPerSpan = 2;
constexpr double kSettled = 1e-13;
constexpr int kSteps = 50;

struct Local {
    Eigen::Vector3d point;
    Eigen::Matrix<double, 3, 2> tangents;
};

Local evaluate(const Net& net, const Eigen::Vector2d& uv) {
    const BasisRow u = basis_row(net.u, uv.x());
    const BasisRow v = basis_row(net.v, uv.y());
    const auto poles = net.local_poles(u.first, v.first);
    return {poles * local_values(u, v), poles * local_basis(u, v).leftCols<2>()};
}

Eigen::Vector2d nearest_of_grid(const Net& net, const Eigen::Vector3d& point) {
    Eigen::Vector2d best = Eigen::Vector2d::Zero();
    double least = std::numeric_limits<double>::infinity();
    const auto node = [](const Axis& axis, int k) {
        const int span = k / kGridPerSpan;
        const double t = (k % kGridPerSpan + 0.5) / kGridPerSpan;
        return axis.lower(span) + t * (axis.upper(span) - axis.lower(span));
    };
    for (int j = 0; j < kGridPerSpan * net.v.spans(); ++j) {
        for (int i = 0; i < kGridPerSpan * net.u.spans(); ++i) {
            const Eigen::Vector2d uv(node(net.u, i), node(net.v, j));
            const double distance = (evaluate(net, uv).point - point).squaredNorm();
            if (distance < least) {
                least = distance;
                best = uv;
            }
        }
    }
    return best;
}

DomainLoop lay_loop(const Net& net, const Scale& scale, const RibbonLoop& loop) {
    const Eigen::VectorXd s = chebyshev_points(kIslandPoints);
    std::vector<Eigen::Matrix2Xd> feet;
    DomainLoop result;
    Eigen::Vector2d at;
    for (std::size_t i = 0; i < loop.ribbons.size(); ++i) {
        Eigen::Matrix2Xd side(2, kIslandPoints);
        Eigen::VectorXd speed(kIslandPoints);
        for (int k = 0; k < kIslandPoints; ++k) {
            const RibbonPoint p = loop.ribbons[i].at(s[k]);
            const Eigen::Vector3d point = (p.point - scale.centre) / scale.length;
            speed[k] = p.tangent.norm();
            if (i == 0 && k == 0) {
                at = nearest_of_grid(net, point);
            }
            at = footpoint(net, point, at);
            side.col(k) = at * scale.length;
        }
        result.lengths.push_back(
            speed.dot(chebyshev_integration(kIslandPoints).col(kIslandPoints - 1)));
        feet.push_back(std::move(side));
    }
    // One corner, one foot.
    for (std::size_t i = 0; i < feet.size(); ++i) {
        feet[(i + 1) % feet.size()].col(0) = feet[i].col(kIslandPoints - 1);
    }
    for (const Eigen::Matrix2Xd& side : feet) {
        result.curves.emplace_back(chebyshev_coefficients(side));
    }
    return result;
}

}  // namespace

std::vector<Eigen::Matrix2Xd> polygons_of(const std::vector<BoundarySample>& samples) {
    std::vector<std::vector<Eigen::Vector2d>> points;
    for (const BoundarySample& sample : samples) {
        if (sample.loop >= 0) {
            points.resize(std::max(points.size(), static_cast<std::size_t>(sample.loop) + 1));
            points[static_cast<std::size_t>(sample.loop)].push_back(sample.uv);
        }
    }
    std::vector<Eigen::Matrix2Xd> result;
    for (const std::vector<Eigen::Vector2d>& loop : points) {
        Eigen::Matrix2Xd polygon(2, static_cast<Eigen::Index>(loop.size()));
        for (std::size_t k = 0; k < loop.size(); ++k) {
            polygon.col(static_cast<Eigen::Index>(k)) = loop[k];
        }
        result.push_back(std::move(polygon));
    }
    return result;
}

Eigen::Vector2d footpoint(const Net& net, const Eigen::Vector3d& point,
                          const Eigen::Vector2d& near) {
    const Eigen::Vector2d lower(net.u.knots.front(), net.v.knots.front());
    const Eigen::Vector2d upper(net.u.knots.back(), net.v.knots.back());
    Eigen::Vector2d uv = near;
    for (int step = 0; step < kSteps; ++step) {
        const Local x = evaluate(net, uv);
        const Eigen::Vector2d change = (x.tangents.transpose() * x.tangents)
                                           .ldlt()
                                           .solve(x.tangents.transpose() * (point - x.point));
        const Eigen::Vector2d next = (uv + change).cwiseMax(lower).cwiseMin(upper);
        const double moved = (next - uv).norm();
        uv = next;
        if (!(moved > kSettled)) {
            break;
        }
    }
    return uv;
}

void lay_on_surface(const Net& net, const Scale& scale, const Hole& hole, Domain& domain) {
    domain.loops.erase(domain.loops.begin() + 1, domain.loops.end());
    for (std::size_t l = 1; l < hole.loops.size(); ++l) {
        domain.loops.push_back(lay_loop(net, scale, hole.loops[l]));
    }
    domain.through.clear();
    for (const ThroughPoint& p : hole.through) {
        const Eigen::Vector3d point = (p.point - scale.centre) / scale.length;
        domain.through.push_back(footpoint(net, point, nearest_of_grid(net, point)) * scale.length);
    }
}

}  // namespace suture::mvs

#include "suture/fill/manifold/convex_map.h"

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <limits>

namespace suture::manifold {
namespace {

using Eigen::Matrix2d;
using Eigen::Vector2d;

/// The angle under which a segment is seen, from its sine and cosine times the same number. Nearly
/// all are small, and a series is several times as fast as the function.
double angle_of(double sine, double cosine) {
    const double t = sine / cosine;
    constexpr double kSmall = 0.03;  // the first term left out is below 3e-15
    if (cosine > 0.0 && std::abs(t) < kSmall) {
        const double t2 = t * t;
        return t * (1.0 - t2 * (1.0 / 3.0 - t2 * (1.0 / 5.0 - t2 * (1.0 / 7.0))));
    }
    return std::atan2(sine, cosine);
}

/// Of the vertices of a polygon, log of the distance from p.
Eigen::ArrayXd logs_of(const Eigen::Matrix2Xd& vertices, const Vector2d& p) {
    constexpr double kTiny = std::numeric_limits<double>::min();
    const Eigen::ArrayXd squares = (vertices.colwise() - p).colwise().squaredNorm().transpose();
    return 0.5 * (squares + kTiny).log();
}

}  // namespace

/// The integral of log |p - q| over q on a segment from a to b, with x and y those of p along it
/// from a and across it, and its slope by p.
template <class Take>
void ConvexMap::for_each_potential(const Vector2d& p, Take&& take) const {
    const Eigen::ArrayXd logs = logs_of(vertices_, p);
    const Eigen::Index n = vertices_.cols();
    for (Eigen::Index j = 0; j < n; ++j) {
        const double log_a = logs[j];
        const double log_b = logs[j + 1 < n ? j + 1 : 0];
        const Vector2d along = along_.col(j);
        const Vector2d across(-along.y(), along.x());
        const Vector2d from_a = p - vertices_.col(j);
        const double x = along.dot(from_a);
        const double y = across.dot(from_a);
        const double rest = lengths_[j] - x;
        const double angle = y == 0.0 ? 0.0 : angle_of(lengths_[j] * y, y * y - x * rest);
        take(j, rest * log_b + x * log_a - lengths_[j] + y * angle,
             Vector2d((log_a - log_b) * along + angle * across));
    }
}

Result<ConvexMap> ConvexMap::make(const std::vector<Vector2d>& boundary,
                                  const std::vector<Vector2d>& images) {
    const std::size_t count = boundary.size();
    const auto n = static_cast<Eigen::Index>(count);
    ConvexMap map;
    map.boundary_ = boundary;
    map.vertices_.resize(2, n);
    map.along_.resize(2, n);
    map.lengths_.resize(n);
    for (Eigen::Index j = 0; j < n; ++j) {
        const Vector2d& a = boundary[static_cast<std::size_t>(j)];
        const Vector2d way = boundary[(static_cast<std::size_t>(j) + 1) % count] - a;
        map.vertices_.col(j) = a;
        map.lengths_[j] = way.norm();
        map.along_.col(j) = way / map.lengths_[j];
    }
    map.size_ = (map.vertices_.rowwise().maxCoeff() - map.vertices_.rowwise().minCoeff()).norm();
    Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(n + 1, n + 1);
    Eigen::MatrixXd wanted = Eigen::MatrixXd::Zero(n + 1, 2);
    for (std::size_t i = 0; i < count; ++i) {
        const auto row = static_cast<Eigen::Index>(i);
        const std::size_t next = (i + 1) % count;
        map.for_each_potential(0.5 * (boundary[i] + boundary[next]),
                               [&](Eigen::Index j, double value, const Vector2d& /*slope*/) {
                                   matrix(row, j) = value;
                               });
        matrix(row, n) = 1.0;
        matrix(n, row) = map.lengths_[row];
        wanted.row(row) = 0.5 * (images[i] + images[next]).transpose();
    }
    const Eigen::MatrixXd solution = matrix.partialPivLu().solve(wanted);
    if (!solution.allFinite()) {
        return fail(ErrorCode::Refused, "has no map onto a convex region");
    }
    map.charges_ = solution.topRows(n).transpose();
    map.constant_ = solution.row(n).transpose();
    map.make_seeds();
    return map;
}

ConvexMap::Value ConvexMap::expand(const Vector2d& p) const {
    Value value{constant_, Matrix2d::Zero()};
    for_each_potential(p, [&](Eigen::Index j, double potential, const Vector2d& slope) {
        const Vector2d charge = charges_.col(j);
        value.point += charge * potential;
        value.slope += charge * slope.transpose();
    });
    return value;
}

Vector2d ConvexMap::at(const Vector2d& p) const {
    return expand(p).point;
}

bool ConvexMap::is_inside(const Vector2d& p) const {
    bool inside = false;
    for (std::size_t i = 0, j = boundary_.size() - 1; i < boundary_.size(); j = i++) {
        const Vector2d& a = boundary_[i];
        const Vector2d& b = boundary_[j];
        if ((a.y() > p.y()) != (b.y() > p.y()) &&
            p.x() < a.x() + (b.x() - a.x()) * (p.y() - a.y()) / (b.y() - a.y())) {
            inside = !inside;
        }
    }
    return inside;
}

bool ConvexMap::is_near_boundary(const Vector2d& p) const {
    for (std::size_t j = 0; j < boundary_.size(); ++j) {
        const Vector2d& a = boundary_[j];
        const Vector2d along = boundary_[(j + 1) % boundary_.size()] - a;
        const double length = along.squaredNorm();
        const double share = std::clamp(along.dot(p - a) / length, 0.0, 1.0);
        if ((a + share * along - p).squaredNorm() < length) {
            return true;
        }
    }
    return false;
}

void ConvexMap::make_seeds() {
    Eigen::AlignedBox2d box;
    for (const Vector2d& p : boundary_) {
        box.extend(p);
    }
    constexpr int kAcross = 32;
    for (int i = 0; i < kAcross; ++i) {
        for (int j = 0; j < kAcross; ++j) {
            const Vector2d share((i + 0.5) / kAcross, (j + 0.5) / kAcross);
            const Vector2d p = box.min() + box.sizes().cwiseProduct(share);
            if (is_inside(p)) {
                seeds_.push_back({p, expand(p)});
            }
        }
    }
}

std::optional<Vector2d> ConvexMap::inverse(const Vector2d& image) const {
    const auto start =
        std::min_element(seeds_.begin(), seeds_.end(), [&](const Seed& a, const Seed& b) {
            return (a.value.point - image).squaredNorm() < (b.value.point - image).squaredNorm();
        });
    if (start == seeds_.end()) {
        return std::nullopt;
    }
    Vector2d p = start->at;
    Value value = start->value;
    // Newton's method; steps that lead outside or away from the image are halved. The last step
    // squares its own length.
    constexpr int kSteps = 40;
    constexpr double kDone = 1e-6;
    for (int step = 0; step < kSteps; ++step) {
        const Vector2d off = value.point - image;
        const Vector2d move = value.slope.inverse() * off;
        if (!move.allFinite()) {
            return std::nullopt;
        }
        if (move.norm() <= kDone * size_) {
            p -= move;
            return is_near_boundary(p) ? std::nullopt : std::optional(p);
        }
        double share = 1.0;
        constexpr double kLeast = 1e-3;
        for (;; share *= 0.5) {
            if (share < kLeast) {
                return std::nullopt;
            }
            const Vector2d tried = p - share * move;
            if (!is_inside(tried)) {
                continue;
            }
            const Value there = expand(tried);
            if ((there.point - image).norm() < off.norm()) {
                p = tried;
                value = there;
                break;
            }
        }
    }
    return std::nullopt;
}

}  // namespace suture::manifold

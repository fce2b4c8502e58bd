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

/// The integral of log |p - q| over q on a segment, and its slope by p.
struct Potential {
    double value = 0.0;
    Vector2d slope = Vector2d::Zero();
};

Potential potential_of(const Vector2d& a, const Vector2d& b, const Vector2d& p) {
    const double length = (b - a).norm();
    const Vector2d along = (b - a) / length;
    const Vector2d across(-along.y(), along.x());
    const double x = along.dot(p - a);
    const double y = across.dot(p - a);
    constexpr double kTiny = std::numeric_limits<double>::min();
    const auto log_at = [&](double z) { return 0.5 * std::log(z * z + y * y + kTiny); };
    const auto turn_at = [&](double z) { return y == 0.0 ? 0.0 : std::atan(z / y); };
    const auto primitive = [&](double z) { return z * log_at(z) - z + y * turn_at(z); };
    const double rest = length - x;
    Potential result;
    result.value = primitive(rest) + primitive(x);
    result.slope = (log_at(x) - log_at(rest)) * along + (turn_at(rest) + turn_at(x)) * across;
    return result;
}

}  // namespace

Result<ConvexMap> ConvexMap::make(const std::vector<Vector2d>& boundary,
                                  const std::vector<Vector2d>& images) {
    const std::size_t count = boundary.size();
    const auto n = static_cast<Eigen::Index>(count);
    ConvexMap map;
    map.boundary_ = boundary;
    Eigen::AlignedBox2d box;
    for (const Vector2d& p : boundary) {
        box.extend(p);
    }
    map.size_ = box.diagonal().norm();
    Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(n + 1, n + 1);
    Eigen::MatrixXd wanted = Eigen::MatrixXd::Zero(n + 1, 2);
    for (std::size_t i = 0; i < count; ++i) {
        const auto row = static_cast<Eigen::Index>(i);
        const std::size_t next = (i + 1) % count;
        const Vector2d middle = 0.5 * (boundary[i] + boundary[next]);
        for (std::size_t j = 0; j < count; ++j) {
            matrix(row, static_cast<Eigen::Index>(j)) =
                potential_of(boundary[j], boundary[(j + 1) % count], middle).value;
        }
        matrix(row, n) = 1.0;
        matrix(n, row) = (boundary[next] - boundary[i]).norm();
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
    for (std::size_t j = 0; j < boundary_.size(); ++j) {
        const Potential part = potential_of(boundary_[j], boundary_[(j + 1) % boundary_.size()], p);
        const Vector2d charge = charges_.col(static_cast<Eigen::Index>(j));
        value.point += charge * part.value;
        value.slope += charge * part.slope.transpose();
    }
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
                seeds_.push_back(p);
                seed_images_.push_back(at(p));
            }
        }
    }
}

std::optional<Vector2d> ConvexMap::inverse(const Vector2d& image) const {
    const Vector2d* start = nullptr;
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < seeds_.size(); ++k) {
        const double distance = (seed_images_[k] - image).squaredNorm();
        if (distance < nearest) {
            nearest = distance;
            start = &seeds_[k];
        }
    }
    if (start == nullptr) {
        return std::nullopt;
    }
    Vector2d p = *start;
    Value value = expand(p);
    // Newton's method; steps that lead outside or away from the image are halved.
    constexpr int kSteps = 40;
    constexpr double kDone = 1e-10;
    for (int step = 0; step < kSteps; ++step) {
        const Vector2d off = value.point - image;
        const Vector2d move = value.slope.inverse() * off;
        if (!move.allFinite()) {
            return std::nullopt;
        }
        if (move.norm() <= kDone * size_) {
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

#include "suture/fill/mvs/polygon.h"

#include <algorithm>

namespace suture::mvs {
namespace {

// Distances below this part of a segment's length are rounding.
constexpr double kRounding = 1e-9;

double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
    return a.x() * b.y() - a.y() * b.x();
}

}  // namespace

std::vector<double> crossings(const std::vector<Eigen::Matrix2Xd>& polygons, double v) {
    std::vector<double> result;
    for (const Eigen::Matrix2Xd& polygon : polygons) {
        const Eigen::Index n = polygon.cols();
        for (Eigen::Index i = 0; i < n; ++i) {
            const Eigen::Vector2d a = polygon.col(i);
            const Eigen::Vector2d b = polygon.col((i + 1) % n);
            if ((a.y() > v) != (b.y() > v)) {
                result.push_back(a.x() + (v - a.y()) / (b.y() - a.y()) * (b.x() - a.x()));
            }
        }
    }
    std::sort(result.begin(), result.end());
    return result;
}

bool crosses_itself(const Eigen::Matrix2Xd& polygon) {
    const Eigen::Index n = polygon.cols();
    const auto point = [&](Eigen::Index i) -> Eigen::Vector2d { return polygon.col(i % n); };
    for (Eigen::Index i = 0; i < n; ++i) {
        const Eigen::Vector2d a = point(i);
        const Eigen::Vector2d d = point(i + 1) - a;
        for (Eigen::Index j = i + 2; j < (i == 0 ? n - 1 : n); ++j) {
            const Eigen::Vector2d p = point(j);
            const Eigen::Vector2d q = point(j + 1);
            const Eigen::Vector2d e = q - p;
            // Straight sides run along themselves: only what is more than rounding counts.
            const double least = kRounding * kRounding * d.squaredNorm() * e.squaredNorm();
            if (cross(d, p - a) * cross(d, q - a) < -least &&
                cross(e, a - p) * cross(e, a + d - p) < -least) {
                return true;
            }
        }
    }
    return false;
}

}  // namespace suture::mvs

#include "suture/fill/mvs/polygon.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace suture::mvs {
namespace {

// Distances below this part of a segment's length are rounding.
constexpr double kRounding = 1e-9;
// Sines of angles below this are those of sides that run into a cusp, which is no crossing.
constexpr double kGrazing = 0.05;

double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
    return a.x() * b.y() - a.y() * b.x();
}

// Whether the segments a-b and p-q cross at more than a grazing angle, or pass each other that
// near.
bool cross_in_space(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& p,
                    const Eigen::Vector3d& q, double limit) {
    const Eigen::Vector3d d = b - a;
    const Eigen::Vector3d e = q - p;
    const double reach = limit + d.norm() + e.norm();
    if ((p - a).squaredNorm() > reach * reach) {
        return false;
    }
    const Eigen::Vector3d normal = d.cross(e);
    const double area = normal.norm();
    if (area <= kGrazing * d.norm() * e.norm()) {
        return false;
    }
    const double s = (p - a).cross(e).dot(normal) / (area * area);
    const double t = (p - a).cross(d).dot(normal) / (area * area);
    return s >= 0.0 && s <= 1.0 && t >= 0.0 && t <= 1.0 &&
           std::abs((p - a).dot(normal)) < limit * area;
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

bool crosses_in_space(const Eigen::Matrix3Xd& polygon, double limit) {
    const Eigen::Index n = polygon.cols();
    for (Eigen::Index i = 0; i < n; ++i) {
        for (Eigen::Index j = i + 2; j < (i == 0 ? n - 1 : n); ++j) {
            if (cross_in_space(polygon.col(i), polygon.col((i + 1) % n), polygon.col(j),
                               polygon.col((j + 1) % n), limit)) {
                return true;
            }
        }
    }
    return false;
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

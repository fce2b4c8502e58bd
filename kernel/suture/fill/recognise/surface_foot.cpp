#include "suture/fill/recognise/surface_foot.h"

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>

namespace suture::recognise {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr int kInSpan = 3;
constexpr int kSteps = 20;
/// A step that leads away is halved so often where the foot is further off than this share of the
/// surface's size: there Newton's method goes astray where a surface bends much. Nearer it would
/// only lead out of the domain, to where the surface's continuation happens to pass.
constexpr int kHalvings = 8;
constexpr double kFar = 1e-3;
constexpr double kSingular = 1e-14;

/// Parameters across a domain, some in each span.
std::vector<double> rows_of(const std::vector<double>& knots, int degree, int count,
                            std::size_t most) {
    std::vector<double> result;
    for (int k = degree; k < count; ++k) {
        const double a = knots[static_cast<std::size_t>(k)];
        const double b = knots[static_cast<std::size_t>(k) + 1];
        for (int i = 0; b > a && i < kInSpan; ++i) {
            result.push_back(a + (b - a) * i / kInSpan);
        }
    }
    result.push_back(knots[static_cast<std::size_t>(count)]);
    if (result.size() > most) {
        const double a = result.front();
        const double b = result.back();
        result.resize(most);
        for (std::size_t i = 0; i < most; ++i) {
            result[i] = a + (b - a) * static_cast<double>(i) / static_cast<double>(most - 1);
        }
    }
    return result;
}

}  // namespace

SurfaceFoot::SurfaceFoot(const SplineSurface& surface, std::size_t rows) : surface_(surface) {
    const std::vector<double> us =
        rows_of(surface.knots_u, surface.degree_u, surface.count_u(), rows);
    for (const double v : rows_of(surface.knots_v, surface.degree_v, surface.count_v(), rows)) {
        for (const double u : us) {
            parameters_.emplace_back(u, v);
        }
    }
    points_.resize(3, static_cast<Eigen::Index>(parameters_.size()));
    for (std::size_t k = 0; k < parameters_.size(); ++k) {
        points_.col(static_cast<Eigen::Index>(k)) =
            evaluate(surface_, parameters_[k].x(), parameters_[k].y()).point;
    }
    size_ = (points_.rowwise().maxCoeff() - points_.rowwise().minCoeff()).norm();
}

Vector2d SurfaceFoot::polished(const Vector3d& point, Vector2d uv) const {
    Vector2d best = uv;
    Vector2d way = Vector2d::Zero();
    double least = INFINITY;
    for (int step = 0, halving = 0; step <= kSteps; ++step) {
        const SurfaceJet jet = evaluate(surface_, uv.x(), uv.y());
        const Vector3d d = jet.point - point;
        const double distance = d.norm();
        if (!(distance < least)) {
            if (halving == kHalvings || least < kFar * size_) {
                break;
            }
            ++halving;
            way *= 0.5;
            uv = best + way;
            continue;
        }
        halving = 0;
        least = distance;
        best = uv;
        Eigen::Matrix2d H;
        H << jet.u.dot(jet.u) + d.dot(jet.uu), jet.u.dot(jet.v) + d.dot(jet.uv),
            jet.u.dot(jet.v) + d.dot(jet.uv), jet.v.dot(jet.v) + d.dot(jet.vv);
        if (!(H.determinant() > kSingular * H.diagonal().cwiseAbs().prod())) {
            // Too far away for Newton's method: without the curvature it descends everywhere.
            H << jet.u.dot(jet.u), jet.u.dot(jet.v), jet.u.dot(jet.v), jet.v.dot(jet.v);
            if (!(H.determinant() > kSingular * H.diagonal().prod())) {
                break;
            }
        }
        way = -(H.inverse() * Vector2d(jet.u.dot(d), jet.v.dot(d)));
        uv = best + way;
    }
    return best;
}

Vector2d SurfaceFoot::find(const Vector3d& point) const {
    Eigen::Index nearest = 0;
    (points_.colwise() - point).colwise().squaredNorm().minCoeff(&nearest);
    return polished(point, parameters_[static_cast<std::size_t>(nearest)]);
}

Foot SurfaceFoot::foot(const Vector3d& point) const {
    const Vector2d uv = find(point);
    const SurfaceJet jet = evaluate(surface_, uv.x(), uv.y());
    return {(jet.point - point).norm(), jet.u.cross(jet.v).normalized()};
}

}  // namespace suture::recognise

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
/// A step that leads away is halved so often. Outside of the domain only where the foot is further
/// off than this share of the surface's size: nearer it would lead on to where the surface's
/// continuation happens to pass.
constexpr int kHalvings = 8;
constexpr double kFar = 1e-3;
/// A step by less than this share of the domain that leads away is rounding.
constexpr double kArrived = 1e-9;
/// A foot that is further out than this share of the domain may be another one than that inside.
constexpr double kBeyond = 1e-3;
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

SurfaceFoot::SurfaceFoot(const SplineSurface& surface, std::size_t rows)
    : surface_(surface),
      low_(surface.knots_u[static_cast<std::size_t>(surface.degree_u)],
           surface.knots_v[static_cast<std::size_t>(surface.degree_v)]),
      width_(surface.knots_u[static_cast<std::size_t>(surface.count_u())] - low_.x(),
             surface.knots_v[static_cast<std::size_t>(surface.count_v())] - low_.y()) {
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

Vector2d SurfaceFoot::polished(const Vector3d& point, const Vector2d& uv) const {
    const Descent free = descend(point, uv, /*stay=*/false);
    const Vector2d beyond = (low_ - free.uv).cwiseMax(free.uv - low_ - width_);
    if (free.settled && (beyond.array() <= kBeyond * width_.array()).all()) {
        return free.uv;
    }
    const Descent inside = descend(point, uv, /*stay=*/true);
    return inside.at_border ? descend(point, inside.uv, /*stay=*/false).uv : inside.uv;
}

SurfaceFoot::Descent SurfaceFoot::descend(const Vector3d& point, Vector2d uv, bool stay) const {
    Descent best{uv};
    Vector2d way = Vector2d::Zero();
    double least = INFINITY;
    for (int step = 0, halving = 0; step <= kSteps; ++step) {
        const SurfaceJet jet = evaluate(surface_, uv.x(), uv.y());
        const Vector3d d = jet.point - point;
        const double distance = d.norm();
        if (!(distance < least)) {
            best.settled = (uv - best.uv).cwiseAbs().maxCoeff() <= kArrived * width_.maxCoeff();
            const bool enough = best.settled || (!stay && least < kFar * size_);
            if (halving == kHalvings || enough) {
                break;
            }
            ++halving;
            way *= 0.5;
            uv = placed(best.uv + way, stay);
            continue;
        }
        halving = 0;
        least = distance;
        best.uv = uv;
        const Vector2d slope(jet.u.dot(d), jet.v.dot(d));
        Eigen::Matrix2d G;
        G << jet.u.dot(jet.u), jet.u.dot(jet.v), jet.u.dot(jet.v), jet.v.dot(jet.v);
        Eigen::Matrix2d H;
        H << G(0, 0) + d.dot(jet.uu), G(0, 1) + d.dot(jet.uv), G(0, 1) + d.dot(jet.uv),
            G(1, 1) + d.dot(jet.vv);
        const Eigen::Array2<bool> held =
            stay ? ends_at(uv, slope) : Eigen::Array2<bool>(false, false);
        best.at_border = held.any();
        if (held.all()) {
            best.settled = true;
            break;
        }
        if (held.any()) {
            // Along the border.
            const int c = held[0] ? 1 : 0;
            way.setZero();
            way[c] = -slope[c] / (H(c, c) > kSingular * G(c, c) ? H(c, c) : G(c, c));
        } else {
            if (!(H.diagonal().minCoeff() > 0.0 &&
                  H.determinant() > kSingular * H.diagonal().prod())) {
                // Too far away for Newton's method: without the curvature it descends everywhere.
                H = G;
                if (!(H.determinant() > kSingular * H.diagonal().prod())) {
                    break;
                }
            }
            way = -(H.inverse() * slope);
        }
        uv = placed(best.uv + way, stay);
    }
    return best;
}

Eigen::Array2<bool> SurfaceFoot::ends_at(const Vector2d& uv, const Vector2d& slope) const {
    return (uv.array() <= low_.array() && slope.array() > 0.0) ||
           (uv.array() >= low_.array() + width_.array() && slope.array() < 0.0);
}

Vector2d SurfaceFoot::placed(const Vector2d& uv, bool stay) const {
    return stay ? Vector2d(uv.cwiseMax(low_).cwiseMin(low_ + width_)) : uv;
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

#include "suture/fill/recognise/border.h"

#include <algorithm>
#include <limits>

namespace suture::recognise {
namespace {

using Eigen::Vector3d;

/// Nothing is as exact as this share of the hole's size: surfaces that files hold as B-splines,
/// feet on them, and coordinates that were rounded when they were written.
constexpr double kLeastNoise = 1e-9;

/// Of what a coordinate is good to.
constexpr double kOfRounding = 4.0;

/// A form with its lengths times `scale`, then moved.
Surface scaled(const Surface& surface, double scale, const Vector3d& shift) {
    return std::visit(
        [&](auto form) -> Surface {
            using T = std::decay_t<decltype(form)>;
            if constexpr (std::is_same_v<T, SplineSurface>) {
                form.poles = (scale * form.poles).colwise() + shift;
            } else {
                form.frame.origin = scale * form.frame.origin + shift;
            }
            if constexpr (std::is_same_v<T, Torus>) {
                form.major *= scale;
                form.minor *= scale;
            } else if constexpr (!std::is_same_v<T, Plane> && !std::is_same_v<T, SplineSurface>) {
                form.radius *= scale;
            }
            return form;
        },
        surface);
}

/// How far the sides miss each other at the corners.
double corner_gap(const Hole& hole) {
    double gap = 0.0;
    for (const RibbonLoop& loop : hole.loops) {
        for (std::size_t i = 0; i < loop.ribbons.size(); ++i) {
            const Ribbon& next = loop.ribbons[(i + 1) % loop.ribbons.size()];
            gap = std::max(gap, (loop.ribbons[i].at(1.0).point - next.at(0.0).point).norm());
        }
    }
    return gap;
}

}  // namespace

Surface Border::to_local(const Surface& surface) const {
    return scaled(surface, 1.0 / size, -origin / size);
}

Surface Border::to_model(const Surface& surface) const {
    return scaled(surface, size, origin);
}

Border border_of(const Hole& hole, double noise) {
    Border border;
    border.size = hole.diameter;
    int count = 0;
    for (std::size_t l = 0; l < hole.loops.size(); ++l) {
        for (const Ribbon& ribbon : hole.loops[l].ribbons) {
            border.sides.push_back({&ribbon, static_cast<int>(l), count, 0.0});
            count += Border::kSamples;
        }
    }
    border.points.resize(3, count);
    border.normals.resize(3, count);
    for (Side& side : border.sides) {
        for (int k = 0; k < Border::kSamples; ++k) {
            // The middles of equal parts: corners, where the neighbours' noise is largest, keep
            // out of the fits.
            const RibbonPoint p = side.ribbon->at((k + 0.5) / Border::kSamples);
            border.points.col(side.first + k) = p.point;
            border.normals.col(side.first + k) = p.normal;
            side.length += p.tangent.norm() / (Border::kSamples * border.size);
        }
    }
    border.origin = border.points.rowwise().mean();
    border.points = (border.points.colwise() - border.origin) / border.size;
    border.rounding =
        std::numeric_limits<double>::epsilon() * (border.origin.norm() + border.size) / border.size;
    border.noise = std::max({corner_gap(hole) / border.size, noise / border.size, kLeastNoise,
                             kOfRounding * border.rounding});
    return border;
}

}  // namespace suture::recognise

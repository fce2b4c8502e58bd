#include "suture/fill/recognise/border.h"

#include <algorithm>
#include <limits>

namespace suture::recognise {
namespace {

using Eigen::Vector3d;

/// Nothing is as exact as this share of the hole's size: surfaces that files hold as B-splines,
/// feet on them, and coordinates that were rounded when they were written.
constexpr double kLeastNoise = 1e-9;

/// So many sides that are not rough tell a surface.
constexpr int kFewestExact = 2;

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

/// How far the sides miss each other at the corners between such as are not rough.
double corner_gap(const Hole& hole, const std::vector<Side>& sides) {
    double gap = 0.0;
    std::size_t first = 0;
    for (const RibbonLoop& loop : hole.loops) {
        const std::size_t n = loop.ribbons.size();
        for (std::size_t i = 0; i < n; ++i) {
            const std::size_t after = (i + 1) % n;
            if (!(sides[first + i].rough > 0.0) && !(sides[first + after].rough > 0.0)) {
                gap = std::max(
                    gap,
                    (loop.ribbons[i].at(1.0).point - loop.ribbons[after].at(0.0).point).norm());
            }
        }
        first += n;
    }
    return gap;
}

/// Marks rough sides.
///
/// Result   the noise of the others.
double set_rough_apart(std::vector<Side>& sides, double noise, double size,
                       const std::vector<double>& of_sides) {
    const auto rough = [&](double one) { return one > kTooNoisy * size; };
    const auto count = std::ranges::count_if(of_sides, rough);
    if (count == 0 || of_sides.size() != sides.size() ||
        static_cast<int>(of_sides.size()) - count < kFewestExact) {
        return noise;
    }
    double exact = 0.0;
    for (std::size_t i = 0; i < sides.size(); ++i) {
        if (rough(of_sides[i])) {
            sides[i].rough = of_sides[i] / size;
        } else {
            exact = std::max(exact, of_sides[i]);
        }
    }
    return exact;
}

}  // namespace

Surface Border::to_local(const Surface& surface) const {
    return scaled(surface, 1.0 / size, -origin / size);
}

Surface Border::to_model(const Surface& surface) const {
    return scaled(surface, size, origin);
}

Eigen::Matrix3Xd with_corners(const Border& border) {
    Eigen::Matrix3Xd points = border.model_points();
    const Eigen::Index count = points.cols();
    points.conservativeResize(3, count + static_cast<Eigen::Index>(border.sides.size()));
    for (std::size_t i = 0; i < border.sides.size(); ++i) {
        points.col(count + static_cast<Eigen::Index>(i)) = border.sides[i].ribbon->at(0.0).point;
    }
    return points;
}

Border exact_part(const Border& border) {
    Border exact = border;
    exact.sides.clear();
    for (const Side& side : border.sides) {
        if (side.rough > 0.0) {
            continue;
        }
        const int first = static_cast<int>(exact.sides.size()) * Border::kSamples;
        exact.points.middleCols<Border::kSamples>(first) =
            border.points.middleCols<Border::kSamples>(side.first);
        exact.normals.middleCols<Border::kSamples>(first) =
            border.normals.middleCols<Border::kSamples>(side.first);
        exact.sides.push_back(side);
        exact.sides.back().first = first;
    }
    const auto count = static_cast<Eigen::Index>(exact.sides.size()) * Border::kSamples;
    exact.points.conservativeResize(Eigen::NoChange, count);
    exact.normals.conservativeResize(Eigen::NoChange, count);
    return exact;
}

Border border_of(const Hole& hole, double noise, const std::vector<double>& of_sides) {
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
    const double exact = set_rough_apart(border.sides, noise, border.size, of_sides);
    border.noise = std::max({corner_gap(hole, border.sides) / border.size, exact / border.size,
                             kLeastNoise, kOfRounding * border.rounding});
    return border;
}

}  // namespace suture::recognise

#include "suture/check/surface_grid.h"

#include <gp_Vec2d.hxx>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <utility>

namespace suture {

namespace {

// Points on each polynomial piece of the surface for each of its degrees, which are the waves that
// it may have, and on all of them in one direction.
constexpr int kPointsOnWave = 3;
constexpr int kFewestPoints = 32;
constexpr int kMostPoints = 192;

constexpr std::ptrdiff_t kMostMinima = 12;

constexpr int kHalvings = 10;

constexpr std::array<std::pair<int, int>, 8> kAround{
    {{-1, -1}, {0, -1}, {1, -1}, {-1, 0}, {1, 0}, {-1, 1}, {0, 1}, {1, 1}}};

std::vector<double> values(int waves, double low, double high) {
    const int count = std::clamp(kPointsOnWave * waves, kFewestPoints, kMostPoints);
    std::vector<double> result;
    result.reserve(static_cast<std::size_t>(count));
    for (int i = 0; i < count; ++i) {
        result.push_back(low + (high - low) * i / (count - 1));
    }
    return result;
}

/// In both directions, the most that the surface may have.
std::pair<int, int> waves_of(const GeomAdaptor_Surface& surface) {
    if (surface.GetType() == GeomAbs_BSplineSurface) {
        // OCCT calls one of class C4 CN, and counts one interval.
        return {surface.UDegree() * (surface.NbUKnots() - 1),
                surface.VDegree() * (surface.NbVKnots() - 1)};
    }
    if (surface.GetType() == GeomAbs_BezierSurface) {
        return {surface.UDegree(), surface.VDegree()};
    }
    constexpr int kUsualDegree = 5;
    return {kUsualDegree * surface.NbUIntervals(GeomAbs_CN),
            kUsualDegree * surface.NbVIntervals(GeomAbs_CN)};
}

}  // namespace

SurfaceGrid::SurfaceGrid(const GeomAdaptor_Surface& surface) {
    const auto [waves_u, waves_v] = waves_of(surface);
    u_ = values(waves_u, surface.FirstUParameter(), surface.LastUParameter());
    v_ = values(waves_v, surface.FirstVParameter(), surface.LastVParameter());
    points_.reserve(u_.size() * v_.size());
    for (const double v : v_) {
        for (const double u : u_) {
            points_.push_back(surface.Value(u, v));
        }
    }
}

std::vector<SurfaceGrid::Minimum> SurfaceGrid::minima(const gp_Pnt& from) const {
    const int n = static_cast<int>(u_.size());
    const int m = static_cast<int>(v_.size());
    std::vector<double> distances(points_.size());
    std::ranges::transform(points_, distances.begin(),
                           [&](const gp_Pnt& point) { return from.SquareDistance(point); });
    const auto index = [&](int i, int j) { return static_cast<std::size_t>(j * n + i); };
    std::vector<Minimum> found;
    for (int j = 0; j < m; ++j) {
        for (int i = 0; i < n; ++i) {
            const std::size_t here = index(i, j);
            bool lowest = true;
            double reach = 0.0;
            for (const auto& [along_u, along_v] : kAround) {
                const int k = i + along_u;
                const int l = j + along_v;
                if (k >= 0 && l >= 0 && k < n && l < m) {
                    lowest = lowest && distances[here] <= distances[index(k, l)];
                    reach = std::max(reach, points_[here].SquareDistance(points_[index(k, l)]));
                }
                if (!lowest) {
                    break;
                }
            }
            if (lowest) {
                const double distance = std::sqrt(distances[here]);
                found.push_back(
                    {gp_Pnt2d(u_[static_cast<std::size_t>(i)], v_[static_cast<std::size_t>(j)]),
                     distance, distance - std::sqrt(reach)});
            }
        }
    }
    std::ranges::stable_sort(found, {}, &Minimum::distance);
    if (std::ssize(found) > kMostMinima) {
        found.erase(found.begin() + kMostMinima, found.end());
    }
    return found;
}

gp_Pnt2d SurfaceGrid::downhill(const GeomAdaptor_Surface& surface, const gp_Pnt& from,
                               const gp_Pnt2d& start) const {
    gp_Pnt2d best = start;
    double smallest = from.SquareDistance(surface.Value(start.X(), start.Y()));
    gp_Vec2d step(0.5 * (u_[1] - u_[0]), 0.5 * (v_[1] - v_[0]));
    for (int k = 0; k < kHalvings; ++k, step *= 0.5) {
        const gp_Pnt2d centre = best;
        for (const auto& [i, j] : kAround) {
            const gp_Pnt2d uv(std::clamp(centre.X() + i * step.X(), u_.front(), u_.back()),
                              std::clamp(centre.Y() + j * step.Y(), v_.front(), v_.back()));
            const double distance = from.SquareDistance(surface.Value(uv.X(), uv.Y()));
            if (distance < smallest) {
                smallest = distance;
                best = uv;
            }
        }
    }
    return best;
}

}  // namespace suture

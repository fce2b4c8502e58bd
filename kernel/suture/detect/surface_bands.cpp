#include "suture/detect/surface_bands.h"

#include "suture/base/tolerance.h"
#include "suture/occ/convert.h"

#include <Eigen/Geometry>

#include <BRep_Tool.hxx>

#include <array>
#include <cmath>

namespace suture {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

/// Surfaces agree to this share of the loop's diameter.
constexpr double kSame = 1e-6;

/// Around a torus there are two ways from loop to loop; only what is clearly the smaller part of it
/// is missing. An elbow of a pipe is no ring that has lost its rest.
constexpr double kSmallerPart = 0.49;

/// How a loop goes around a surface.
struct Around {
    int coordinate = 0;   ///< that goes around: 0 = u
    double side = 0.0;    ///< +1: the hole lies above the loop in the other coordinate
    double at = 0.0;      ///< where the loop lies in it
    double period = 0.0;  ///< of the other coordinate, or 0
};

std::optional<Around> around(const Surface& surface, const LoopShape& shape) {
    const std::array<bool, 2> periodic = {periodic_u(surface), periodic_v(surface)};
    const Vector2d start = parameters_of(surface, shape.points.front());
    Vector2d now = start;
    Vector2d mean = Vector2d::Zero();
    double outward = 0.0;
    const auto step = [&](const Vector3d& p) {
        const Vector2d raw = parameters_of(surface, p);
        for (const int c : {0, 1}) {
            now[c] = periodic[static_cast<std::size_t>(c)]
                         ? now[c] + std::remainder(raw[c] - now[c], 2.0 * kPi)
                         : raw[c];
        }
    };
    for (std::size_t i = 0; i < shape.points.size(); ++i) {
        step(shape.points[i]);
        mean += now / static_cast<double>(shape.points.size());
        const SurfaceJet jet = evaluate(surface, now.x(), now.y());
        outward += jet.u.cross(jet.v).normalized().dot(shape.along[i].cross(shape.onward[i]));
    }
    step(shape.points.front());
    const Vector2d turns = (now - start) / (2.0 * kPi);
    for (const int c : {0, 1}) {
        if (periodic[static_cast<std::size_t>(c)] && std::lround(std::abs(turns[c])) == 1 &&
            (!periodic[static_cast<std::size_t>(1 - c)] || std::lround(turns[1 - c]) == 0)) {
            const double left = (c == 0 ? turns[c] : -turns[c]) * outward;
            const double period = periodic[static_cast<std::size_t>(1 - c)] ? 2.0 * kPi : 0.0;
            return Around{c, left > 0.0 ? 1.0 : -1.0, mean[1 - c], period};
        }
    }
    return std::nullopt;
}

/// The way up from one loop to the other; nothing: there is none.
std::optional<double> way_up(const Around& low, const Around& high) {
    double way = high.at - low.at;
    if (low.period > 0.0) {
        way -= std::floor(way / low.period) * low.period;
        if (way > kSmallerPart * low.period) {
            return std::nullopt;
        }
    }
    return way > 0.0 ? std::optional(way) : std::nullopt;
}

}  // namespace

std::optional<Surface> common_surface(const BoundaryLoop& loop, const LoopShape& shape) {
    std::optional<Surface> common;
    TopoDS_Face last;
    for (const BoundaryEdge& edge : loop.edges) {
        if (edge.face.IsSame(last)) {
            continue;
        }
        last = edge.face;
        const auto form = occ::from_occ(BRep_Tool::Surface(edge.face));
        if (!form) {
            return std::nullopt;
        }
        if (!common) {
            common = form->surface;
        } else if (!on_one_surface(common, form->surface, shape)) {
            return std::nullopt;
        }
    }
    return common;
}

bool on_one_surface(const std::optional<Surface>& a, const std::optional<Surface>& b,
                    const LoopShape& shape) {
    return a && b &&
           same_surface(*a, *b, shape.points.front(), shape.diameter, kSame * shape.diameter);
}

std::vector<std::pair<int, int>> find_surface_bands(
    const std::vector<std::optional<Surface>>& surfaces, const std::vector<LoopShape>& shapes) {
    const int n = static_cast<int>(surfaces.size());
    // From loop to loop, seen on the surface of the first of the two.
    const auto way = [&](int low, int high) -> std::optional<double> {
        const auto& surface = surfaces[static_cast<std::size_t>(std::min(low, high))];
        if (low == high || !surface || !periodic_u(*surface) ||
            !on_one_surface(surfaces[static_cast<std::size_t>(low)],
                            surfaces[static_cast<std::size_t>(high)],
                            shapes[static_cast<std::size_t>(low)])) {
            return std::nullopt;
        }
        const auto a = around(*surface, shapes[static_cast<std::size_t>(low)]);
        const auto b = around(*surface, shapes[static_cast<std::size_t>(high)]);
        return a && b && a->coordinate == b->coordinate && a->side > 0.0 && b->side < 0.0
                   ? way_up(*a, *b)
                   : std::nullopt;
    };
    std::vector<int> above(surfaces.size(), -1);
    std::vector<int> below(surfaces.size(), -1);
    for (int low = 0; low < n; ++low) {
        for (int high = 0; high < n; ++high) {
            const auto here = way(low, high);
            if (!here) {
                continue;
            }
            int& up = above[static_cast<std::size_t>(low)];
            int& down = below[static_cast<std::size_t>(high)];
            up = up < 0 || *here < *way(low, up) ? high : up;
            down = down < 0 || *here < *way(down, high) ? low : down;
        }
    }
    std::vector<std::pair<int, int>> pairs;
    for (int low = 0; low < n; ++low) {
        const int high = above[static_cast<std::size_t>(low)];
        if (high >= 0 && below[static_cast<std::size_t>(high)] == low) {
            pairs.emplace_back(low, high);
        }
    }
    return pairs;
}

}  // namespace suture

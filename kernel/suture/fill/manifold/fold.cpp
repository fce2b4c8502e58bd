#include "suture/fill/manifold/fold.h"

#include "suture/base/tolerance.h"
#include "suture/fill/manifold/layout.h"
#include "suture/fill/manifold/quad_map.h"

#include <Eigen/Geometry>

#include <cmath>
#include <functional>
#include <vector>

namespace suture::manifold {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

/// A fold turns the normal over; a tight bend between two samples turns it by less.
constexpr double kSharpest = radians(120.0);

/// A point of a surface and its normal, of any length.
struct Place {
    Vector3d point, normal;
};

/// Looks at all neighbours in a grid of samples.
void look(int rows, int columns, int side, const std::function<Place(double s, double t)>& at,
          std::optional<Fold>& worst) {
    std::vector<Place> before;
    for (int i = 0; i < rows; ++i) {
        std::vector<Place> row;
        for (int j = 0; j < columns; ++j) {
            row.push_back(at((i + 0.5) / rows, (j + 0.5) / columns));
            for (const Place* other : {i > 0 ? &before[static_cast<std::size_t>(j)] : nullptr,
                                       j > 0 ? &row[row.size() - 2] : nullptr}) {
                if (other == nullptr) {
                    continue;
                }
                const double angle = std::atan2(row.back().normal.cross(other->normal).norm(),
                                                row.back().normal.dot(other->normal));
                if (angle > std::max(kSharpest, worst ? worst->angle : 0.0)) {
                    worst = Fold{row.back().point, angle, side};
                }
            }
        }
        before = std::move(row);
    }
}

}  // namespace

std::optional<Fold> find_fold(const StarSurface& surface) {
    const Star& star = surface.star();
    const QuadMap map(star);
    std::optional<Fold> worst;
    constexpr int kAcross = 8;
    constexpr int kAlong = 64;
    constexpr int kMiddle = 24;
    for (int m = 0; m < star.n(); ++m) {
        const SplineSurface strip = border_spline(surface, m);
        const auto in_strip = [&](double s, double t) -> Place {
            const double inner = star.inner();
            const double low = (1.0 - s) * -map.reach() + s * lower_end(star, m);
            const double high = (1.0 - s) * map.reach() + s * upper_end(star, m);
            const SurfaceJet jet =
                evaluate(strip, inner + s * (star.border(m) - inner), low + t * (high - low));
            return {jet.point, jet.u.cross(jet.v)};
        };
        if (star.border(m) > star.inner()) {
            look(kAcross, kAlong, m, in_strip, worst);
        }
        const auto in_middle = [&](double s, double t) -> Place {
            const Series<3> series = surface.expand(map.at(m, {s, t}), 1);
            const Vector3d x = series.derivative(1, 0);
            return {series.derivative(0, 0), x.cross(Vector3d(series.derivative(0, 1)))};
        };
        look(kMiddle, kMiddle, m, in_middle, worst);
    }
    return worst;
}

std::optional<Fold> find_fold(const SplineSurface& ring) {
    std::optional<Fold> worst;
    constexpr int kAcross = 32;
    const int along = 4 * ring.count_v();
    const auto at = [&](double s, double t) -> Place {
        const SurfaceJet jet = evaluate(ring, s * ring.knots_u.back(), t * ring.knots_v.back());
        return {jet.point, jet.u.cross(jet.v)};
    };
    look(kAcross, along, 0, at, worst);
    return worst;
}

}  // namespace suture::manifold

#include "suture/fill/manifold/spacing.h"

#include "suture/base/tolerance.h"

#include <algorithm>
#include <cmath>

namespace suture::manifold {
namespace {

/// Joints this near to the middle of a side, as shares of half its length, are moved there.
constexpr double kNearMiddle = 0.3;
/// The first layer stays at least this wide: the aperture has to stay below a share of it.
constexpr double kLeastFirst = 0.5;

/// Adds knots around a place and takes those away that stand closer than they.
void crowd(std::vector<double>& knots, double at, int levels, double least, double most) {
    std::vector<double> crowded = {at};
    double distance = 1.0;
    for (int level = 0; level < levels; ++level) {
        distance /= 2.0;
        crowded.push_back(at - distance);
        crowded.push_back(at + distance);
    }
    std::erase_if(crowded, [&](double t) { return t < least || t > most; });
    constexpr double kClose = 0.6;
    for (const double t : crowded) {
        const double room = kClose * std::max(std::abs(t - at), distance);
        std::erase_if(knots, [&](double old) {
            return old != knots.front() && old != knots.back() && std::abs(old - t) < room;
        });
    }
    for (const double t : crowded) {
        const bool taken = std::any_of(knots.begin(), knots.end(), [&](double old) {
            return std::abs(old - t) < kClose * distance;
        });
        if (!taken) {
            knots.insert(std::upper_bound(knots.begin(), knots.end(), t), t);
        }
    }
}

/// Halves the widest intervals until there are `intervals`; the innermost ones stay.
void fill_up(std::vector<double>& knots, std::size_t intervals, std::size_t innermost) {
    while (knots.size() < intervals + 1) {
        std::size_t widest = innermost;
        for (std::size_t i = innermost; i + 1 < knots.size(); ++i) {
            constexpr double kWider = 1.001;
            if (knots[i + 1] - knots[i] > kWider * (knots[widest + 1] - knots[widest])) {
                widest = i;
            }
        }
        knots.insert(knots.begin() + static_cast<std::ptrdiff_t>(widest) + 1,
                     0.5 * (knots[widest] + knots[widest + 1]));
    }
}

}  // namespace

Spacing spacing_for(int k, int layers, double aperture,
                    const std::vector<std::vector<double>>& joints, int levels) {
    const auto n = static_cast<int>(joints.size());
    const int outer = (k + 1) / 2;  // layers beyond the border
    const int border = layers - outer;
    Spacing spacing;
    spacing.size.k = k;
    spacing.size.layers = layers;
    spacing.size.columns.assign(joints.size(), 1);
    spacing.size.aperture = aperture;
    spacing.centres.assign(joints.size(), 0.0);
    if (std::all_of(joints.begin(), joints.end(), [](const auto& own) { return own.empty(); })) {
        return spacing;
    }
    if (aperture == 0.0) {
        constexpr double kShare = 0.8;
        spacing.size.aperture = std::min(Star::default_aperture(k, spacing.size.columns),
                                         kShare * kLeastFirst * Star::aperture_bound(k, n));
    }
    const double sine = std::sin(2.0 * kPi / n);
    const double f_y = 0.5 * spacing.size.aperture * sine;
    const double reach = f_y + sine * border;
    std::vector<std::vector<double>> rays(joints.size());
    for (std::vector<double>& ray : rays) {
        for (int i = 0; i <= border; ++i) {
            ray.push_back(i);
        }
    }
    spacing.size.given.resize(joints.size());
    for (int m = 0; m < n; ++m) {
        const auto side = static_cast<std::size_t>(m);
        double& centre = spacing.centres[side];
        double nearest = kNearMiddle;
        for (const double share : joints[side]) {
            if (std::abs(2.0 * share - 1.0) < nearest) {
                centre = 2.0 * share - 1.0;
                nearest = std::abs(centre);
            }
        }
        std::vector<double> middle = {-1.0, 1.0};
        for (const double share : joints[side]) {
            const double t = 2.0 * share - 1.0;
            const double y = reach * (t - centre * (1.0 - t * t) / (1.0 - centre * centre));
            if (std::abs(y) < f_y) {
                crowd(middle, y / f_y, levels, -1.0, 1.0);
                continue;
            }
            const int ray = y > 0.0 ? m + 1 : m - 1;
            const double depth = (std::abs(y) - f_y) / sine;
            crowd(rays[static_cast<std::size_t>((ray + n) % n)], depth, levels, kLeastFirst,
                  border);
        }
        spacing.size.columns[side] = static_cast<int>(middle.size()) - 1;
        spacing.size.given[side].middle = std::move(middle);
    }
    std::size_t most = 0;
    for (const std::vector<double>& ray : rays) {
        most = std::max(most, ray.size() - 1);
    }
    for (int m = 0; m < n; ++m) {
        std::vector<double>& ray = rays[static_cast<std::size_t>(m)];
        const auto innermost =
            static_cast<std::size_t>(std::min(k + 2, static_cast<int>(ray.size()) - 2));
        fill_up(ray, most, innermost);
        const double last = ray.back() - ray[ray.size() - 2];
        for (int i = 1; i <= outer; ++i) {
            ray.push_back(border + i * last);
        }
        spacing.size.given[static_cast<std::size_t>(m)].depth = std::move(ray);
    }
    spacing.size.layers = static_cast<int>(most) + outer;
    return spacing;
}

}  // namespace suture::manifold

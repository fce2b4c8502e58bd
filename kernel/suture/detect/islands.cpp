#include "suture/detect/islands.h"

#include "suture/base/tolerance.h"
#include "suture/detect/surface_bands.h"

#include <Eigen/Geometry>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace suture {

namespace {

/// Planes, circles and axes agree to this share of the loops' diameter.
constexpr double kSame = 1e-6;

/// A face whose direction at the loop makes an angle of more than 120 degrees with where the
/// neighbour goes on would fold back onto it.
constexpr double kFolds = -0.5;

/// A band between two circles is likelier than two discs where it goes on from both neighbours that
/// much straighter (difference of cosines: 0 or 90 against 90 or 180 degrees give 1).
constexpr double kStraighter = 0.5;

bool same_direction(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
    return a.cross(b).norm() <= kSame;
}

bool same_plane(const LoopShape& a, const LoopShape& b) {
    const double scale = kSame * std::max(a.diameter, b.diameter);
    return a.flatness <= scale && b.flatness <= scale && same_direction(a.axis, b.axis) &&
           std::abs(a.axis.dot(b.centre - a.centre)) <= scale;
}

/// How often the loop goes around p, both in one plane.
int winding_number(const LoopShape& loop, const Eigen::Vector3d& p) {
    double angle = 0.0;
    for (std::size_t i = 0; i < loop.points.size(); ++i) {
        const Eigen::Vector3d a = loop.points[i] - p;
        const Eigen::Vector3d b = loop.points[(i + 1) % loop.points.size()] - p;
        angle += std::atan2(loop.axis.dot(a.cross(b)), a.dot(b));
    }
    return static_cast<int>(std::lround(angle / (2.0 * kPi)));
}

/// Mean cosine between where the neighbours go on and the plane's side to the left of the walk.
double goes_left_in_plane(const LoopShape& loop, const Eigen::Vector3d& normal) {
    double sum = 0.0;
    for (std::size_t i = 0; i < loop.points.size(); ++i) {
        sum += loop.onward[i].dot(normal.cross(loop.along[i]));
    }
    return sum / static_cast<double>(loop.points.size());
}

bool open_to_fill(const BoundaryLoop& loop) {
    return loop.kind != LoopKind::Seam && loop.kind != LoopKind::Slit;
}

/// `inner` bounds an island in the plane face that `outer` bounds from outside.
bool is_planar_island(const LoopShape& outer, const LoopShape& inner) {
    return outer.spanned_area > inner.spanned_area && same_plane(outer, inner) &&
           outer.axis.dot(inner.axis) < 0.0 && winding_number(outer, inner.points.front()) != 0 &&
           goes_left_in_plane(outer, outer.axis) > kFolds &&
           goes_left_in_plane(inner, outer.axis) > kFolds;
}

void join(std::vector<BoundaryLoop>& loops, const std::vector<int>& members, LoopKind kind,
          const std::string& why) {
    for (const int a : members) {
        loops[a].kind = kind;
        loops[a].reason = why;
        for (const int b : members) {
            if (a != b) {
                loops[a].islands_with.push_back(loops[b].id);
            }
        }
    }
}

void find_planar_islands(std::vector<BoundaryLoop>& loops, const std::vector<LoopShape>& shapes) {
    const int n = static_cast<int>(loops.size());
    std::vector<std::vector<int>> inside(n);
    for (int inner = 0; inner < n; ++inner) {
        int nearest = -1;
        for (int outer = 0; outer < n && open_to_fill(loops[inner]); ++outer) {
            if (outer != inner && open_to_fill(loops[outer]) &&
                is_planar_island(shapes[outer], shapes[inner]) &&
                (nearest < 0 || shapes[outer].spanned_area < shapes[nearest].spanned_area)) {
                nearest = outer;
            }
        }
        if (nearest >= 0) {
            inside[nearest].push_back(inner);
        }
    }
    for (int outer = 0; outer < n; ++outer) {
        if (!inside[outer].empty() && loops[outer].islands_with.empty()) {
            std::vector<int> members = inside[outer];
            members.push_back(outer);
            join(loops, members, LoopKind::Hole,
                 "the loops lie in one plane, one inside the other, and turn against each other: "
                 "they bound one missing plane face");
        }
    }
}

struct Circle {
    int loop = 0;
    Eigen::Vector3d centre;
    double radius = 0.0;
    double onward_out = 0.0;   ///< how far the neighbours go on away from the axis
    double onward_axis = 0.0;  ///< and along it (the loop's own axis)
};

std::optional<Circle> as_circle(const LoopShape& shape, int loop) {
    if (shape.flatness > kSame * shape.diameter) {
        return {};
    }
    // points of several arcs do not lie evenly: the centre comes from three of them
    const std::size_t n = shape.points.size();
    const Eigen::Vector3d& a = shape.points[0];
    const Eigen::Vector3d u = shape.points[n / 3] - a;
    const Eigen::Vector3d v = shape.points[2 * n / 3] - a;
    const Eigen::Vector3d w = u.cross(v);
    if (w.norm() <= kSame * u.norm() * v.norm()) {
        return {};
    }
    Circle circle;
    circle.loop = loop;
    circle.centre =
        a + (u.squaredNorm() * v.cross(w) + v.squaredNorm() * w.cross(u)) / (2.0 * w.squaredNorm());
    circle.radius = (a - circle.centre).norm();
    for (std::size_t i = 0; i < n; ++i) {
        const Eigen::Vector3d spoke = shape.points[i] - circle.centre;
        if (std::abs(spoke.norm() - circle.radius) > kSame * shape.diameter) {
            return {};
        }
        circle.onward_out += shape.onward[i].dot(spoke.normalized()) / static_cast<double>(n);
        circle.onward_axis += shape.onward[i].dot(shape.axis) / static_cast<double>(n);
    }
    return circle;
}

/// Cosine between where the neighbours of `from` go on and the band that leads to `to`, if they
/// have one axis and go around it against each other.
std::optional<double> goes_to(const Circle& from, const Circle& to,
                              const std::vector<LoopShape>& shapes) {
    const Eigen::Vector3d& axis = shapes[from.loop].axis;
    const Eigen::Vector3d between = to.centre - from.centre;
    const double height = axis.dot(between);
    const double scale = kSame * std::max(shapes[from.loop].diameter, shapes[to.loop].diameter);
    if (!same_direction(axis, shapes[to.loop].axis) || axis.dot(shapes[to.loop].axis) > 0.0 ||
        (between - height * axis).norm() > scale || std::abs(height) <= scale) {
        return {};
    }
    const double widening = to.radius - from.radius;
    return (from.onward_out * widening + from.onward_axis * height) / std::hypot(widening, height);
}

bool band_is_straighter(const Circle& from, const Circle& to,
                        const std::vector<LoopShape>& shapes) {
    const std::optional<double> band = goes_to(from, to, shapes);
    const double disc = -from.onward_out;
    return band && *band - disc > kStraighter;
}

/// How far each neighbour has to go on, in the half-plane of the axis, until they meet; nothing:
/// they do not meet ahead of both.
std::optional<std::pair<double, double>> ways_to_meeting(const Circle& a, const Circle& b,
                                                         const std::vector<LoopShape>& shapes) {
    const Eigen::Vector3d& axis = shapes[a.loop].axis;
    const double side = axis.dot(shapes[b.loop].axis) > 0.0 ? 1.0 : -1.0;
    const Eigen::Vector2d from_a(a.onward_out, a.onward_axis);
    const Eigen::Vector2d from_b(b.onward_out, side * b.onward_axis);
    const Eigen::Vector2d between(b.radius - a.radius, axis.dot(b.centre - a.centre));
    const auto cross = [](const Eigen::Vector2d& x, const Eigen::Vector2d& y) {
        return x.x() * y.y() - x.y() * y.x();
    };
    const double sine = cross(from_a, from_b);
    if (std::abs(sine) <= kSame) {
        return std::nullopt;
    }
    const double way_a = cross(between, from_b) / sine;
    const double way_b = cross(between, from_a) / sine;
    if (way_a <= 0.0 || way_b <= 0.0) {
        return std::nullopt;
    }
    return std::pair(way_a, way_b);
}

/// A fillet of one radius between the neighbours of two circles about one axis is missing: where
/// they meet is equally far from both. Discs in the circles would leave two bodies, or a step.
bool bound_a_fillet(const Circle& a, const Circle& b, const std::vector<LoopShape>& shapes) {
    if (!goes_to(a, b, shapes)) {
        return false;
    }
    const auto ways = ways_to_meeting(a, b, shapes);
    return ways && std::abs(ways->first - ways->second) <=
                       kSame * std::max(shapes[a.loop].diameter, shapes[b.loop].diameter);
}

std::string band_reason(const Surface& surface) {
    return fmt::format(
        "two loops around one {}, which goes on from both towards the other: the band between them "
        "is missing",
        kind_name(surface));
}

void find_bands_of_one_surface(std::vector<BoundaryLoop>& loops,
                               const std::vector<LoopShape>& shapes,
                               const std::vector<std::optional<Surface>>& surfaces) {
    for (const auto& [low, high] : find_surface_bands(surfaces, shapes)) {
        join(loops, {low, high}, LoopKind::Hole,
             band_reason(*surfaces[static_cast<std::size_t>(low)]));
    }
}

std::vector<Circle> circles_in_question(const std::vector<BoundaryLoop>& loops,
                                        const std::vector<LoopShape>& shapes) {
    std::vector<Circle> circles;
    for (int i = 0; i < static_cast<int>(loops.size()); ++i) {
        const std::optional<Circle> circle = as_circle(shapes[i], i);
        if (circle && open_to_fill(loops[i]) && loops[i].islands_with.empty()) {
            circles.push_back(*circle);
        }
    }
    return circles;
}

void find_fillets(std::vector<BoundaryLoop>& loops, const std::vector<LoopShape>& shapes,
                  const std::vector<int>& solid) {
    const std::vector<Circle> circles = circles_in_question(loops, shapes);
    const auto nearest = [&](const Circle& from) {
        const Circle* best = nullptr;
        for (const Circle& other : circles) {
            const int a = solid[static_cast<std::size_t>(from.loop)];
            const int b = solid[static_cast<std::size_t>(other.loop)];
            const bool different_bodies = a > 0 && b > 0 && a != b;
            if (other.loop != from.loop && !different_bodies &&
                bound_a_fillet(from, other, shapes) &&
                (best == nullptr ||
                 (other.centre - from.centre).norm() < (best->centre - from.centre).norm())) {
                best = &other;
            }
        }
        return best;
    };
    for (const Circle& a : circles) {
        const Circle* b = nearest(a);
        if (b != nullptr && b->loop > a.loop && nearest(*b) == &a) {
            join(loops, {a.loop, b->loop}, LoopKind::Hole,
                 "two circles about one axis whose neighbours meet equally far from both: the "
                 "fillet between them is missing");
        }
    }
}

void find_bands(std::vector<BoundaryLoop>& loops, const std::vector<LoopShape>& shapes,
                const std::vector<int>& component,
                const std::vector<std::optional<Surface>>& surfaces) {
    const std::vector<Circle> circles = circles_in_question(loops, shapes);
    const auto nearest = [&](const Circle& from) {
        int best = -1;
        for (int k = 0; k < static_cast<int>(circles.size()); ++k) {
            const auto distance = [&](int c) { return (circles[c].centre - from.centre).norm(); };
            if (circles[k].loop != from.loop && band_is_straighter(from, circles[k], shapes) &&
                (best < 0 || distance(k) < distance(best))) {
                best = k;
            }
        }
        return best;
    };
    for (int a = 0; a < static_cast<int>(circles.size()); ++a) {
        const int b = nearest(circles[a]);
        if (b <= a || nearest(circles[b]) != a) {
            continue;
        }
        const bool discs_fold = -circles[a].onward_out < kFolds && -circles[b].onward_out < kFolds;
        const bool one_shell = component[circles[a].loop] == component[circles[b].loop];
        const std::vector<int> members{circles[a].loop, circles[b].loop};
        const auto& surface = surfaces[static_cast<std::size_t>(circles[a].loop)];
        if (on_one_surface(surface, surfaces[static_cast<std::size_t>(circles[b].loop)],
                           shapes[static_cast<std::size_t>(circles[a].loop)])) {
            join(loops, members, LoopKind::Hole, band_reason(*surface));
        } else if (discs_fold && one_shell) {
            join(loops, members, LoopKind::Hole,
                 "two circles about one axis; a band between them goes on from both sides, while a "
                 "disc in either would fold back onto the material");
        } else {
            join(loops, members, LoopKind::Ambiguous,
                 "two circles about one axis: one band between them or a disc in each would close "
                 "the shape");
        }
    }
}

}  // namespace

void find_islands(std::vector<BoundaryLoop>& loops, const std::vector<LoopShape>& shapes,
                  const std::vector<int>& component, const std::vector<int>& solid) {
    find_planar_islands(loops, shapes);
    std::vector<std::optional<Surface>> surfaces;
    for (std::size_t i = 0; i < loops.size(); ++i) {
        const bool in_question = open_to_fill(loops[i]) && loops[i].islands_with.empty();
        surfaces.push_back(in_question ? common_surface(loops[i], shapes[i]) : std::nullopt);
    }
    find_bands_of_one_surface(loops, shapes, surfaces);
    find_fillets(loops, shapes, solid);
    find_bands(loops, shapes, component, surfaces);
}

}  // namespace suture

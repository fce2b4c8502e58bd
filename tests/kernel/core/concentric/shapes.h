#pragma once

#include "suture/base/tolerance.h"
#include "suture/fill/concentric/closed_spline.h"

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <vector>

/// Simple closed polygons, and B-spline curves with them as control polygons.
namespace suture::shapes {

using Points = std::vector<Eigen::Vector2d>;

inline Points rectangle() {
    return {{0, 0}, {4, 0}, {4, 2}, {0, 2}};
}
inline Points letter_l() {
    return {{0, 0}, {6, 0}, {6, 2}, {2, 2}, {2, 5}, {0, 5}};
}
inline Points letter_t() {
    return {{0, 0}, {8, 0}, {8, 2}, {5, 2}, {5, 6}, {3, 6}, {3, 2}, {0, 2}};
}
inline Points letter_z() {
    return {{0, 0}, {4, 0}, {4, 3}, {7, 3}, {7, 5}, {2, 5}, {2, 2}, {0, 2}};
}
inline Points arrow() {
    return {{0, 0}, {8, 0}, {8, 4}, {4, 1.5}, {0, 4}};
}
inline Points pentagon() {
    return {{0, 0}, {5, -1}, {7, 2}, {4, 5}, {-1, 3}};
}
/// A random polygon on which the paper's parameters fold.
inline Points folding() {
    return {{1.8866, .0774},  {1.6859, .5935}, {-1.4663, .1669}, {-1.0979, -.0127},
            {-1.529, -.6395}, {.8997, -.9753}, {1.467, -.83}};
}

/// An ellipse's polygon with noise on its radius.
inline Points noisy_ellipse(int n, double noise, unsigned seed = 7) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> wobble(-noise, noise);
    Points points;
    for (int k = 0; k < n; ++k) {
        const double phi = 2.0 * kPi * k / n;
        points.push_back((1.0 + wobble(random)) *
                         Eigen::Vector2d(3.0 * std::cos(phi), 1.5 * std::sin(phi)));
    }
    return points;
}

/// Teeth upwards: every second corner is reflex.
inline Points comb(int teeth, double depth) {
    Points points = {{0.0, 0.0}, {2.0 * teeth, 0.0}};
    for (int k = teeth - 1; k >= 0; --k) {
        points.emplace_back(2.0 * k + 2.0, 1.0 + depth);
        points.emplace_back(2.0 * k + 1.0, 1.0 + depth);
        if (k > 0) {
            points.emplace_back(2.0 * k + 1.0, 1.0);
            points.emplace_back(2.0 * k, 1.0);
        }
    }
    points.emplace_back(1.0, 1.0);
    points.emplace_back(0.0, 1.0);
    return points;
}

/// A band that winds about its start.
inline Points spiral(double turns, int n, double width) {
    Points points;
    Points inner;
    for (int k = 0; k <= n; ++k) {
        const double phi = 2.0 * kPi * turns * k / n;
        const double r = 1.0 + 0.5 * phi;
        const Eigen::Vector2d e(std::cos(phi), std::sin(phi));
        points.push_back((r + width) * e);
        inner.push_back(r * e);
    }
    points.insert(points.end(), inner.rbegin(), inner.rend());
    return points;
}

/// Radii at random about a centre: star-shaped, with deep bays.
inline Points star(int n, double least, std::mt19937& random) {
    std::uniform_real_distribution<double> radius(least, 1.0);
    Points points;
    for (int k = 0; k < n; ++k) {
        const double phi = 2.0 * kPi * k / n;
        points.push_back(radius(random) * Eigen::Vector2d(std::cos(phi), std::sin(phi)));
    }
    return points;
}

inline double turn(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c) {
    return (b - a).x() * (c - a).y() - (b - a).y() * (c - a).x();
}

/// Points at random, their tour uncrossed until it is simple.
inline Points scattered(int n, std::mt19937& random) {
    std::uniform_real_distribution<double> coordinate(-1.0, 1.0);
    Points p;
    for (int k = 0; k < n; ++k) {
        p.emplace_back(2.0 * coordinate(random), coordinate(random));
    }
    const auto size = p.size();
    for (bool changed = true; changed;) {
        changed = false;
        for (std::size_t i = 0; i < size && !changed; ++i) {
            for (std::size_t k = i + 2; k < size && !changed; ++k) {
                const auto& a = p[i];
                const auto& b = p[i + 1];
                const auto& c = p[k];
                const auto& d = p[(k + 1) % size];
                if ((k + 1) % size != i && turn(a, b, c) * turn(a, b, d) < 0.0 &&
                    turn(c, d, a) * turn(c, d, b) < 0.0) {
                    std::reverse(p.begin() + static_cast<std::ptrdiff_t>(i) + 1,
                                 p.begin() + static_cast<std::ptrdiff_t>(k) + 1);
                    changed = true;
                }
            }
        }
    }
    return p;
}

inline double area(const Points& p) {
    double sum = 0.0;
    for (std::size_t i = 0; i < p.size(); ++i) {
        const auto& a = p[i];
        const auto& b = p[(i + 1) % p.size()];
        sum += 0.5 * (a.x() * b.y() - a.y() * b.x());
    }
    return sum;
}

/// A closed B-spline with simple knots, vertex i of its polygon given; counterclockwise.
inline concentric::ClosedSpline spline(Points points, int degree) {
    if (area(points) < 0.0) {
        std::reverse(points.begin(), points.end());
    }
    const auto n = static_cast<int>(points.size());
    concentric::ClosedSpline curve;
    curve.degree = degree;
    curve.poles.resize(2, n);
    for (int i = 0; i < n; ++i) {
        curve.poles.col(i) = points[static_cast<std::size_t>(i)];
        curve.knots.push_back(i);
    }
    curve.knots.push_back(n);
    return curve;
}
inline concentric::ClosedSpline polygon(const Points& points) {
    return spline(points, 1);
}

/// Whether a curve's chords, 24 to a span, cross nowhere: a simple polygon may have a curve that is
/// not.
inline bool is_simple(const concentric::ClosedSpline& curve) {
    if (curve.degree == 1) {
        return true;
    }
    constexpr int kChords = 24;
    const SplineCurve around = concentric::unrolled(curve);
    Points p;
    for (int k = 0; k < kChords * curve.count(); ++k) {
        p.emplace_back(evaluate(around, around.begin() + static_cast<double>(k) / kChords));
    }
    const std::size_t n = p.size();
    for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t k = i + 2; k < n; ++k) {
            const auto& a = p[i];
            const auto& b = p[i + 1];
            const auto& c = p[k];
            const auto& d = p[(k + 1) % n];
            if ((k + 1) % n != i && turn(a, b, c) * turn(a, b, d) < 0.0 &&
                turn(c, d, a) * turn(c, d, b) < 0.0) {
                return false;
            }
        }
    }
    return true;
}

struct Named {
    std::string name;
    concentric::ClosedSpline curve;
};

/// 500 shapes: convex, concave, combs, spirals, nearly degenerate; polygons and curves.
inline std::vector<Named> five_hundred() {
    std::mt19937 random(20031);
    std::vector<Named> all;
    const auto add = [&](const std::string& name, const Points& points) {
        const int degree = static_cast<int>(all.size() % 5) + 1;
        const concentric::ClosedSpline curve = spline(points, degree);
        if (is_simple(curve)) {
            all.push_back({name + ", degree " + std::to_string(degree), curve});
        }
    };
    const auto between = [&](int low, int high) {
        return std::uniform_int_distribution<int>(low, high)(random);
    };
    const auto real = [&](double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(random);
    };
    // Curves that cross themselves are left out, and others drawn for them.
    const auto until = [&](std::size_t count, const auto& draw) {
        for (int k = 0; all.size() < count; ++k) {
            draw(k);
        }
    };
    until(100,
          [&](int k) { add("convex " + std::to_string(k), noisy_ellipse(between(4, 24), 0.0)); });
    until(200, [&](int k) {
        add("noisy " + std::to_string(k),
            noisy_ellipse(between(8, 40), real(0.0, 0.15), static_cast<unsigned>(k)));
    });
    until(280, [&](int k) {
        add("star " + std::to_string(k), star(between(5, 20), real(0.15, 0.9), random));
    });
    until(400,
          [&](int k) { add("scattered " + std::to_string(k), scattered(between(5, 16), random)); });
    until(430,
          [&](int k) { add("comb " + std::to_string(k), comb(between(2, 8), real(0.1, 6.0))); });
    until(460, [&](int k) {
        add("spiral " + std::to_string(k), spiral(real(0.5, 3.0), between(12, 60), real(0.3, 1.5)));
    });
    until(500, [&](int k) {
        // Slivers, needles, vertices that nearly touch a side or each other, straight angles.
        const double tiny = std::pow(10.0, real(-7.0, -1.0));
        const Points points[] = {
            {{0, 0}, {10, 0}, {10, tiny}, {0, tiny}},
            {{0, 0}, {4, 0}, {4, 2}, {2 + tiny, 2}, {2, 6}, {2 - tiny, 2}, {0, 2}},
            {{0, 0}, {4, 0}, {4, 2}, {2, tiny}, {0, 2}},
            {{0, 0}, {1, tiny}, {2, 0}, {3, -tiny}, {4, 0}, {4, 2}, {2, 2 + tiny}, {0, 2}}};
        add("near-degenerate " + std::to_string(k), points[k % 4]);
    });
    return all;
}

}  // namespace suture::shapes

/// Seconds that the concentric fill of a planar hole takes against the number of its segments, as
/// the table of docs/methods/concentric.md: the map alone, and all of the fill with one face for
/// each side. Best of three.
#include "suture/fill/concentric.h"
#include "suture/fill/concentric/map.h"

#include <Eigen/Geometry>

#include "kernel/core/concentric/shapes.h"
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>

namespace {

using namespace suture;
using Eigen::Vector2d;
using shapes::Points;

template <class Work>
double seconds_of(const Work& work) {
    double best = INFINITY;
    constexpr int kRuns = 3;
    for (int run = 0; run < kRuns; ++run) {
        const auto start = std::chrono::steady_clock::now();
        work();
        const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - start;
        best = std::min(best, passed.count());
    }
    return best;
}

/// A polygon as a hole in the plane of x and y, whose sides are lines.
Hole hole_of(const Points& points) {
    Hole hole;
    auto& ribbons = hole.loops.emplace_back().ribbons;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Vector2d a = points[i];
        const Vector2d b = points[(i + 1) % points.size()];
        SplineCurve line{1, {0, 0, 1, 1}, Eigen::MatrixXd::Zero(3, 2)};
        line.poles.topRows(2) << a, b;
        Ribbon& ribbon = ribbons.emplace_back();
        ribbon.continuity = Continuity::G0;
        ribbon.curve = line;
        ribbon.at = [=](double s) {
            RibbonPoint point;
            point.point = evaluate(line, s).col(0);
            point.tangent << b - a, 0.0;
            point.normal = -Eigen::Vector3d::UnitZ().cross(point.tangent).normalized();
            point.inward = -Eigen::Vector3d::UnitZ();
            point.curvature.setZero();
            return point;
        };
    }
    return hole;
}

/// "map / fill" for one shape.
std::string cell(const concentric::ClosedSpline& curve, const Points& points) {
    const concentric::MapOptions options{0.1, 0.02, true, 8, true};
    const double map = seconds_of([&] { concentric_map(curve, options).value(); });
    const Hole hole = hole_of(points);
    const double fill = seconds_of([&] { fill_concentric(hole, {}).value(); });
    return fmt::format("{:.3f} / {:.3f}", map, fill);
}

}  // namespace

int main() {
    fmt::print(
        "| segments | noisy ellipse: map / fill | comb: map / fill | cubic ellipse: map |\n");
    fmt::print("|---|---|---|---|\n");
    for (const int n : {100, 300, 1000, 3000, 10000}) {
        const Points noisy = shapes::noisy_ellipse(n, 0.3 / n);
        const Points comb = shapes::comb(n / 4, 3.0);
        const auto cubic = shapes::spline(shapes::noisy_ellipse(n, 0.0), 3);
        const double smooth = seconds_of([&] {
            concentric_map(cubic, {0.1, 0.02, true, 8, true}).value();
        });
        fmt::print("| {} | {} | {} | {:.3f} |\n", n, cell(shapes::polygon(noisy), noisy),
                   cell(shapes::polygon(comb), comb), smooth);
    }
    return 0;
}

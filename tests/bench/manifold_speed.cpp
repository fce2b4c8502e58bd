/// Points a second: the manifold patch against OCCT's plain evaluation of a B-spline surface of the
/// same degree and net. Prints one line for each number of sides and order.
#include "suture/fill/manifold/layout.h"
#include "suture/fill/manifold/surface.h"
#include "suture/occ/convert.h"

#include <Geom_Surface.hxx>

#include <chrono>
#include <cmath>
#include <cstdio>
#include <random>
#include <vector>

namespace {

using namespace suture;

/// The best of several runs, in seconds for one evaluation.
template <class Evaluate>
double seconds_of(const Evaluate& evaluate, int count) {
    double best = 1.0;
    constexpr int kRuns = 7;
    for (int run = 0; run < kRuns; ++run) {
        const auto start = std::chrono::steady_clock::now();
        for (int i = 0; i < count; ++i) {
            evaluate(i);
        }
        const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - start;
        best = std::min(best, passed.count() / count);
    }
    return best;
}

/// Whether a point costs no more than n + 2 of the plain ones.
bool compare(int n, int k) {
    manifold::StarSize size;
    size.k = k;
    size.layers = manifold::Star::least_layers(k, n) + 2;
    size.columns.assign(static_cast<std::size_t>(n), 1);
    const manifold::Star star = manifold::Star::make(size).value();
    const Eigen::Matrix3Xd points = Eigen::Matrix3Xd::Random(3, star.count());
    const manifold::StarSurface surface(star, points);
    const SplineSurface strip = manifold::border_spline(surface, 0);
    const auto plain = occ::to_occ(strip).value();
    std::mt19937 random(1);
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    constexpr int kPoints = 20000;
    std::vector<Eigen::Vector2d> in_x;
    std::vector<Eigen::Vector2d> in_strip;
    const double reach = star.inner();
    for (int i = 0; i < kPoints; ++i) {
        const double r = reach * unit(random);
        const double a = 7.0 * unit(random);
        in_x.emplace_back(r * std::cos(a), r * std::sin(a));
        in_strip.emplace_back(star.inner() + (star.border(0) - star.inner()) * unit(random),
                              star.f_y() * (2.0 * unit(random) - 1.0));
    }
    double sum = 0.0;  // so that nothing is left out
    const double ours = seconds_of(
        [&](int i) { sum += surface.at(in_x[static_cast<std::size_t>(i)]).x(); }, kPoints);
    const double theirs = seconds_of(
        [&](int i) {
            const Eigen::Vector2d& at = in_strip[static_cast<std::size_t>(i)];
            sum += plain->Value(at.x(), at.y()).X();
        },
        kPoints);
    std::printf("n = %d, k = %d: %.3g points/s, B-spline %.3g points/s, %.2f times its cost (%s)\n",
                n, k, 1.0 / ours, 1.0 / theirs, ours / theirs,
                std::isfinite(sum) && ours <= (n + 2) * theirs ? "within n + 2" : "above n + 2");
    return ours <= (n + 2) * theirs;
}

}  // namespace

int main() {
    bool within = true;
    for (const int n : {3, 5, 7}) {
        for (const int k : {1, 2, 3}) {
            within = compare(n, k) && within;
        }
    }
    return within ? 0 : 1;
}

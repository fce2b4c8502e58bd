#include "suture/fill/algebraic/sheet.h"

#include "suture/fill/algebraic/jets.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>

namespace suture::algebraic {

using Eigen::Vector3d;

Sheet::Sheet(const Problem& problem, const Solution& solution, int sector)
    : centre_(problem.view.centre), sign_(problem.view.sign) {
    const Sector& s = solution.partition.sectors[static_cast<std::size_t>(sector)];
    g_ = solution.cells[static_cast<std::size_t>(s.cell)];
    directions_ = directions_of(s, solution.rays);
    const auto n = static_cast<Eigen::Index>(problem.guide.size());
    guide_b_.resize(3, n);
    guide_t_.resize(n);
    for (Eigen::Index i = 0; i < n; ++i) {
        const OnRay at =
            on_ray(directions_, problem.guide[static_cast<std::size_t>(i)].point - centre_);
        guide_b_.col(i) = at.b;
        guide_t_[i] = at.t;
    }
}

double Sheet::guess(const Vector3d& b) const {
    Eigen::Index nearest = 0;
    (guide_b_.colwise() - b).colwise().squaredNorm().minCoeff(&nearest);
    return guide_t_[nearest];
}

std::optional<Vector3d> Sheet::at(const Vector3d& b, double t) const {
    const Vector3d ray = directions_ * b;
    const auto value = [&](double s) {
        const ValueAndGradient g = evaluate(g_, centre_ + s * ray);
        return std::pair(sign_ * g.value, sign_ * g.gradient.dot(ray));
    };
    // A bracket around the guess, grown until the sign changes.
    constexpr double kReach = 1.0 / 3.0;
    constexpr double kGrowth = 1.7;
    double low = t;
    double high = t;
    double step = 1e-3;
    while (value(low).first > 0.0 || value(high).first < 0.0) {
        if (step > kReach) {
            return std::nullopt;
        }
        (value(low).first > 0.0 ? low : high) = value(low).first > 0.0 ? t * (1.0 - step)  //
                                                                       : t * (1.0 + step);
        step *= kGrowth;
    }
    // Newton's method, by bisection where it leaves the bracket.
    double root = 0.5 * (low + high);
    constexpr int kSteps = 80;
    for (int n = 0; n < kSteps; ++n) {
        const auto [f, df] = value(root);
        (f > 0.0 ? high : low) = root;
        double next = df != 0.0 ? root - f / df : low;
        if (!(next >= low && next <= high)) {
            next = 0.5 * (low + high);
        }
        if (std::abs(next - root) <= 4e-16 * std::abs(root)) {
            return centre_ + next * ray;
        }
        root = next;
    }
    return centre_ + root * ray;
}

}  // namespace suture::algebraic

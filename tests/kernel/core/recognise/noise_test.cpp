#include "suture/fill/recognise.h"
#include "suture/fill/recognise/form.h"

#include <Eigen/QR>

#include "kernel/core/recognise/closed_forms.h"
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace suture {
namespace {

using closed_forms::sizes;
using closed_forms::Truth;
using closed_forms::truths;
using closed_forms::without_supports;
using Eigen::Vector3d;

// One side's edge lies 4e-4 of the hole's diameter off its own neighbour, the others are exact.
TEST(FillRecognise, HearsNothingFromARoughSide) {
    for (const Truth& truth : truths(1.0, false)) {
        if (std::holds_alternative<Sphere>(truth.surface)) {
            continue;  // two sides of three: less than is asked for
        }
        Hole hole = without_supports(windows::window_in(truth.surface, truth.window));
        Ribbon& rough = hole.loops[0].ribbons[1];
        const double size = 4e-4 * hole.diameter;
        rough.at = [at = rough.at, size](double s) {
            RibbonPoint p = at(s);
            p.point += size * std::sin(kPi * s) * p.normal;
            return p;
        };
        FillOptions options;
        options.noise = size;
        EXPECT_FALSE(fill_recognise(hole, options)) << kind_name(truth.surface);
        options.side_noise.assign(hole.loops[0].ribbons.size(), 0.0);
        options.side_noise[1] = size;
        const auto fill = fill_recognise(hole, options);
        const bool plain = std::holds_alternative<Cylinder>(truth.surface) ||
                           std::holds_alternative<Torus>(truth.surface);
        if (!plain) {
            EXPECT_FALSE(fill) << kind_name(truth.surface);  // no round number speaks for it
            continue;
        }
        ASSERT_TRUE(fill) << kind_name(truth.surface) << ": " << fill.error().message;
        const Surface& found = fill->patches.front().surface;
        ASSERT_EQ(kind_name(found), kind_name(truth.surface));
        const auto is = sizes(found);
        const auto real = sizes(truth.surface);
        for (std::size_t i = 0; i < real.size(); ++i) {
            EXPECT_NEAR(is[i], real[i], 1e-8 * real[i]) << kind_name(truth.surface);
        }
        // 1.54 times as far as its own edge is no noise of it.
        options.side_noise[1] = 0.65 * size;
        options.noise = 0.65 * size;
        EXPECT_FALSE(fill_recognise(hole, options)) << kind_name(truth.surface);
    }
}

/// Distance of a point, in a closed form's own frame, from it.
double residual(const Surface& surface, const Vector3d& p, const std::vector<double>& size) {
    const double rho = std::hypot(p.x(), p.y());
    if (std::holds_alternative<Sphere>(surface)) {
        return p.norm() - size[0];
    }
    if (std::holds_alternative<Cylinder>(surface)) {
        return rho - size[0];
    }
    if (const auto* cone = std::get_if<Cone>(&surface)) {
        return (rho - cone->radius) * std::cos(size[0]) - p.z() * std::sin(size[0]);
    }
    return std::hypot(rho - size[0], p.z()) - size[1];
}

/// By how much a least-squares fit of the border can miss each size, at most, where every point of
/// the border is off by one unit: the sums of the rows of the pseudo-inverse of the distances'
/// derivatives by the six motions and the sizes.
std::vector<double> amplification(const Surface& surface, const Hole& hole) {
    const Frame frame = recognise::frame_of(surface);
    std::vector<Vector3d> points;
    for (const Ribbon& ribbon : hole.loops[0].ribbons) {
        for (int k = 0; k < 24; ++k) {
            const Vector3d d = ribbon.at((k + 0.5) / 24.0).point - frame.origin;
            points.emplace_back(d.dot(frame.x), d.dot(frame.y), d.dot(frame.z));
        }
    }
    const std::vector<double> real = sizes(surface);
    const auto count = static_cast<Eigen::Index>(real.size());
    Eigen::MatrixXd J(static_cast<Eigen::Index>(points.size()), 6 + count);
    constexpr double kStep = 1e-5;
    for (Eigen::Index i = 0; i < J.rows(); ++i) {
        for (Eigen::Index j = 0; j < J.cols(); ++j) {
            const auto at = [&](double step) {
                Vector3d p = points[static_cast<std::size_t>(i)];
                std::vector<double> size = real;
                if (j < 3) {
                    p[j] -= step;
                } else if (j < 6) {
                    p = Eigen::AngleAxisd(-step, Vector3d::Unit(j - 3)) * p;
                } else {
                    size[static_cast<std::size_t>(j - 6)] += step;
                }
                return residual(surface, p, size);
            };
            J(i, j) = (at(kStep) - at(-kStep)) / (2.0 * kStep);
        }
    }
    // Motions of a form in itself are no part of it.
    Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> fit;
    fit.setThreshold(1e-7);
    const Eigen::MatrixXd inverse = fit.compute(J).pseudoInverse();
    std::vector<double> sums;
    for (Eigen::Index j = 0; j < count; ++j) {
        sums.push_back(inverse.row(6 + j).cwiseAbs().sum());
    }
    return sums;
}

// Thirty dirty variants: edges off their neighbours by up to 1e-4 of the hole's diameter, which the
// file states as their tolerance. Sizes are within the noise, times what the border makes of it.
TEST(FillRecognise, FindsTheSameKindAndSizesThroughNoise) {
    int plain = 0;
    int all = 0;
    std::mt19937 random(7);
    for (const double noise : {1e-5, 5e-5, 1e-4}) {
        for (int variant = 0; variant < 2; ++variant) {
            for (const Truth& truth : truths(1.0, variant == 1)) {
                Hole hole = without_supports(windows::window_in(truth.surface, truth.window));
                FillOptions options;
                options.noise = noise * hole.diameter;
                std::uniform_real_distribution<double> phase(0.0, 6.0);
                for (Ribbon& ribbon : hole.loops[0].ribbons) {
                    const double a = phase(random);
                    const double size = noise * hole.diameter;
                    ribbon.at = [at = ribbon.at, a, size](double s) {
                        RibbonPoint p = at(s);
                        p.point += size * std::sin(a + 9.0 * s) * p.normal;
                        return p;
                    };
                }
                const auto fill = fill_recognise(hole, options);
                ASSERT_TRUE(fill) << kind_name(truth.surface) << ": " << fill.error().message;
                const Patch& patch = fill->patches.front();
                ASSERT_EQ(kind_name(patch.surface), kind_name(truth.surface)) << noise;
                EXPECT_LT(windows::fit_of(hole, patch).gap, 3.0 * noise * hole.diameter);
                const auto found = sizes(patch.surface);
                const auto real = sizes(truth.surface);
                if (real.empty()) {
                    continue;
                }
                const auto most =
                    amplification(truth.surface, windows::window_in(truth.surface, truth.window));
                for (std::size_t i = 0; i < real.size(); ++i) {
                    const double error = std::abs(found[i] - real[i]);
                    EXPECT_LE(error, noise * std::min(hole.diameter * most[i], 100.0 * real[i]))
                        << kind_name(truth.surface) << ", noise " << noise;
                    ++all;
                    plain += error < 1e-9 ? 1 : 0;
                }
            }
        }
    }
    // Where the number is plain it is found through the noise, all but a few times.
    EXPECT_EQ(all, 30);
    EXPECT_GE(plain, 20);
}

}  // namespace
}  // namespace suture

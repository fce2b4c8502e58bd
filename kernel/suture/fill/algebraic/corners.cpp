#include "suture/fill/algebraic/corners.h"

#include "suture/fill/algebraic/jets.h"

#include <algorithm>

namespace suture::algebraic {
namespace {

/// Curvatures in unit coordinates, where 1 is a hole that turns by about a radian.
constexpr double kSameCurvature = 1e-6;

}  // namespace

Result<void> expect_agreeing_corners(const Problem& problem) {
    const bool by_jets = !problem.jets.empty();
    const std::size_t n = problem.curves.size();
    for (std::size_t i = 0; i < n; ++i) {
        const std::size_t before = (i + n - 1) % n;
        const int k = by_jets ? std::min(problem.jets[before].k, problem.jets[i].k)
                              : std::min(problem.sides[before].k, problem.sides[i].k);
        if (std::min(k, problem.interface_k) < 2) {
            continue;
        }
        const Eigen::Vector3d corner = problem.curves[i](0.0);
        const Eigen::Matrix3d a = by_jets ? problem.jets[before].jets.back().curvature
                                          : curvature(problem.sides[before].f, corner);
        const Eigen::Matrix3d b = by_jets ? problem.jets[i].jets.front().curvature
                                          : curvature(problem.sides[i].f, corner);
        const double largest = std::max(a.norm(), b.norm());
        if ((a - b).norm() > kSameCurvature * std::max(1.0, largest)) {
            return fail(ErrorCode::Refused,
                        "no surface that is regular in the corner of sides {} and {} is G^{} with "
                        "both: their curvatures differ there by {:.3g} % of the larger; G^1 can do",
                        before + 1, i + 1, k, 100.0 * std::min(1.0, (a - b).norm() / largest));
        }
    }
    return {};
}

}  // namespace suture::algebraic

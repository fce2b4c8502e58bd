// The nearest point of a SurfaceTree.
#include "suture/check/surface_tree.h"

#include <algorithm>

namespace suture {

namespace {

constexpr int kNewtonSteps = 30;
// A step this small against the distance that the surface's derivatives span ends the search.
constexpr double kSettled = 1e-12;

}  // namespace

/// Levenberg's steps: each is taken only if it comes nearer.
std::optional<SurfacePoint> SurfaceTree::foot(const Eigen::Vector3d& from,
                                              std::array<double, 2> start) const {
    SurfacePoint here = at(clamped(start)[0], clamped(start)[1]);
    double damping = 0.0;
    for (int step = 0; step < kNewtonSteps; ++step) {
        const Eigen::Vector3d r = from - here.point;
        Eigen::Matrix2d I;
        I << here.du.squaredNorm(), here.du.dot(here.dv), here.du.dot(here.dv),
            here.dv.squaredNorm();
        Eigen::Vector2d g(here.du.dot(r), here.dv.dot(r));
        I.diagonal() *= 1.0 + damping;
        for (const std::size_t k : {0U, 1U}) {
            // A parameter at its bound that wants to leave stays there.
            const auto e = static_cast<Eigen::Index>(k);
            if (bounded_.at(k) && ((here.uv.at(k) <= bounds_.low.at(k) && g[e] < 0.0) ||
                                   (here.uv.at(k) >= bounds_.high.at(k) && g[e] > 0.0))) {
                g[e] = I(0, 1) = I(1, 0) = 0.0;
            }
        }
        const double determinant = I.determinant();
        if (!(determinant > 0.0)) {
            return std::nullopt;
        }
        const Eigen::Vector2d d((I(1, 1) * g[0] - I(0, 1) * g[1]) / determinant,
                                (I(0, 0) * g[1] - I(0, 1) * g[0]) / determinant);
        const auto next_uv = clamped({here.uv[0] + d[0], here.uv[1] + d[1]});
        const Eigen::Vector3d move =
            (next_uv[0] - here.uv[0]) * here.du + (next_uv[1] - here.uv[1]) * here.dv;
        const double size = here.point.cwiseAbs().maxCoeff() + r.norm();
        if (move.norm() <= kSettled * size) {
            return here;
        }
        const SurfacePoint next = at(next_uv[0], next_uv[1]);
        if ((from - next.point).norm() <= r.norm() * (1.0 + 1e-14)) {
            here = next;
            damping *= 0.1;
        } else {
            damping = std::max(10.0 * damping, 0.1);
        }
    }
    return here;
}

std::optional<SurfacePoint> SurfaceTree::nearest(const Eigen::Vector3d& from, double limit) {
    std::optional<SurfacePoint> best;
    std::vector<int> stack = {0};
    while (!stack.empty()) {
        const int i = stack.back();
        stack.pop_back();
        if (cell(i).part == FaceDomain::Part::Outside ||
            cell(i).box.exteriorDistance(from) > limit) {
            continue;
        }
        if (!cell(i).flat_known) {
            const int first = split(i);
            const bool one_first =
                cell(first).box.exteriorDistance(from) < cell(first + 1).box.exteriorDistance(from);
            stack.push_back(one_first ? first + 1 : first);
            stack.push_back(one_first ? first : first + 1);
            continue;
        }
        const auto found = foot(from, {cell(i).uv.middle(0), cell(i).uv.middle(1)});
        if (!found) {
            continue;
        }
        const double reached = (found->point - from).norm();
        if (reached <= limit && contains(found->uv)) {
            limit = reached;
            best = found;
        }
    }
    return best;
}

}  // namespace suture

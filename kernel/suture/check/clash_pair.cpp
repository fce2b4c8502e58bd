#include "suture/check/clash_pair.h"

#include <algorithm>

namespace suture {

namespace {

// Points along the stretch on which two triangles meet, between its ends.
constexpr int kPointsOnMeeting = 3;
// The first step away from a crossing, in tolerances.
constexpr double kFirstStep = 2.0;
// Corners of two cells nearer to each other than this part of their size are one.
constexpr double kSameCorner = 1e-7;

using Triangle = std::array<std::size_t, 3>;
constexpr std::array<Triangle, 2> kTriangles = {{{0, 1, 2}, {0, 2, 3}}};

std::array<Eigen::Vector3d, 3> triangle_of(const SurfaceTree::Cell& cell, const Triangle& t) {
    return {cell.corners.at(t[0]), cell.corners.at(t[1]), cell.corners.at(t[2])};
}

ParameterBox united(const ParameterBox& a, const ParameterBox& b) {
    return {{std::min(a.low[0], b.low[0]), std::min(a.low[1], b.low[1])},
            {std::max(a.high[0], b.high[0]), std::max(a.high[1], b.high[1])}};
}

/// Across a seam, or at a pole, where any number of cells meet.
bool share_corner(const SurfaceTree::Cell& one, const SurfaceTree::Cell& two) {
    const double same = kSameCorner * (one.box.diagonal().norm() + two.box.diagonal().norm());
    for (const Eigen::Vector3d& p : one.corners) {
        for (const Eigen::Vector3d& q : two.corners) {
            if ((p - q).squaredNorm() <= same * same) {
                return true;
            }
        }
    }
    return false;
}

/// Parameters of a point of one of the cell's triangles.
std::array<double, 2> parameters_in(const SurfaceTree::Cell& cell, const Triangle& t,
                                    const Eigen::Vector3d& point) {
    const auto p = triangle_of(cell, t);
    const SurfacePoint plane{{}, p[0], p[1] - p[0], p[2] - p[0]};
    const auto [a, b] = plane.parameters_of(point - p[0]);
    const auto corner = [&](std::size_t k) -> std::array<double, 2> {
        return {k == 1 || k == 2 ? cell.uv.high[0] : cell.uv.low[0],
                k >= 2 ? cell.uv.high[1] : cell.uv.low[1]};
    };
    std::array<double, 2> uv = {};
    for (const std::size_t k : {0U, 1U}) {
        const double origin = corner(t[0]).at(k);
        uv.at(k) = origin + a * (corner(t[1]).at(k) - origin) + b * (corner(t[2]).at(k) - origin);
    }
    return uv;
}

}  // namespace

void ClashPair::look(int i, int j) {
    const auto lies_out = [](const SurfaceTree::Cell& cell) {
        return cell.part == FaceDomain::Part::Outside;
    };
    if (more_ <= 0 || lies_out(a_.cell(i)) || lies_out(b_.cell(j)) ||
        !a_.cell(i).box.intersects(b_.cell(j).box)) {
        return;
    }
    const bool leaf_a = is_leaf(a_, a_.cell(i));
    const bool leaf_b = is_leaf(b_, b_.cell(j));
    if (is_self() && i == j) {
        if (!leaf_a && !passes_not_itself(i, i)) {
            const int first = a_.split(i);
            look(first, first);
            look(first, first + 1);
            look(first + 1, first + 1);
        }
        return;
    }
    if (is_self() && a_.cell(i).uv.meets(a_.cell(j).uv) && passes_not_itself(i, j)) {
        return;
    }
    if (leaf_a && leaf_b) {
        meet(a_.cell(i), b_.cell(j));
        return;
    }
    const auto size = [](const SurfaceTree::Cell& cell) { return cell.box.diagonal().norm(); };
    if (!leaf_a && (leaf_b || size(a_.cell(i)) >= size(b_.cell(j)))) {
        const int first = a_.split(i);
        look(first, j);
        look(first + 1, j);
    } else {
        const int first = b_.split(j);
        look(i, first);
        look(i, first + 1);
    }
}

/// Over the box around two cells that touch: proven by the control net, else seen by their points.
bool ClashPair::passes_not_itself(int i, int j) const {
    const SurfaceTree::Cell& one = a_.cell(i);
    const SurfaceTree::Cell& two = a_.cell(j);
    if (a_.is_injective(united(one.uv, two.uv))) {
        return true;
    }
    if (!one.flat_known || !two.flat_known) {
        return false;
    }
    std::vector<Eigen::Vector3d> by_u = one.by_u;
    std::vector<Eigen::Vector3d> by_v = one.by_v;
    by_u.insert(by_u.end(), two.by_u.begin(), two.by_u.end());
    by_v.insert(by_v.end(), two.by_v.begin(), two.by_v.end());
    return is_monotone(by_u, by_v);
}

void ClashPair::meet(const SurfaceTree::Cell& one, const SurfaceTree::Cell& two) {
    if (is_self() && (one.uv.meets(two.uv) || share_corner(one, two))) {
        return;
    }
    const double margin = tolerance_ + one.sag + two.sag;
    for (const Triangle& ta : kTriangles) {
        for (const Triangle& tb : kTriangles) {
            const auto meeting = meeting_of(triangle_of(one, ta), triangle_of(two, tb));
            if (!meeting) {
                continue;
            }
            for (int k = 0; k < kPointsOnMeeting && more_ > 0; ++k) {
                const double s = (k + 0.5) / kPointsOnMeeting;
                const Eigen::Vector3d x = (1.0 - s) * meeting->ends[0] + s * meeting->ends[1];
                const auto uv_a = parameters_in(one, ta, x);
                const auto uv_b = parameters_in(two, tb, x);
                if (a_.contains(uv_a) && b_.contains(uv_b) && !shared_.is_near(x, margin)) {
                    refine(uv_a, uv_b);
                }
            }
        }
    }
}

void ClashPair::refine(const std::array<double, 2>& uv_a, const std::array<double, 2>& uv_b) {
    const auto found = refine_crossing(a_, b_, uv_a, uv_b, kFirstStep * allowed_);
    if (!found || found->depth <= allowed_ || shared_.is_near(found->point, tolerance_)) {
        return;
    }
    --more_;
    if (!best_ || found->depth > best_->depth) {
        best_ = found;
    }
}

}  // namespace suture

#include "suture/fill/algebraic/guide.h"

#include "suture/fill/mvs.h"

#include <Eigen/Geometry>

#include <cmath>

namespace suture::algebraic {
namespace {

using Eigen::Vector2d;

constexpr int kOnSide = 33;
/// Points across the domain's box: a few times as many as a polynomial of degree 6 could tell
/// apart.
constexpr int kAcross = 33;

bool is_inside(const std::vector<Vector2d>& polygon, const Vector2d& p) {
    bool inside = false;
    for (std::size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++) {
        const Vector2d& a = polygon[i];
        const Vector2d& b = polygon[j];
        if ((a.y() > p.y()) != (b.y() > p.y()) &&
            p.x() < a.x() + (b.x() - a.x()) * (p.y() - a.y()) / (b.y() - a.y())) {
            inside = !inside;
        }
    }
    return inside;
}

}  // namespace

Result<std::vector<GuidePoint>> guide_by_mvs(const Hole& hole, const Unit& unit,
                                             const FillOptions& options) {
    FillOptions plain = options;
    plain.own.clear();
    const auto fill = fill_mvs(hole, plain);
    if (!fill) {
        return fail(fill.error().code, "no surface to go by: {}", fill.error().message);
    }
    const Patch& patch = fill->patches.front();
    std::vector<Vector2d> polygon;
    Eigen::AlignedBox2d box;
    for (const EdgeUse& use : patch.wires.front()) {
        for (int n = 0; n + 1 < kOnSide; ++n) {
            polygon.push_back(use.at(static_cast<double>(n) / (kOnSide - 1)));
            box.extend(polygon.back());
        }
    }
    std::vector<GuidePoint> guide;
    for (int i = 1; i < kAcross; ++i) {
        for (int j = 1; j < kAcross; ++j) {
            const Vector2d uv =
                box.min() + box.sizes().cwiseProduct(Vector2d(i, j)) / static_cast<double>(kAcross);
            if (is_inside(polygon, uv)) {
                const SurfaceJet jet = evaluate(patch.surface, uv.x(), uv.y());
                const double side = patch.reversed ? -1.0 : 1.0;
                guide.push_back({unit.in(jet.point), side * jet.u.cross(jet.v).normalized()});
            }
        }
    }
    for (const Ribbon& ribbon : hole.loops.front().ribbons) {
        for (int n = 0; n + 1 < kOnSide; ++n) {
            const RibbonPoint p = ribbon.at(static_cast<double>(n) / (kOnSide - 1));
            guide.push_back({unit.in(p.point), p.normal});
        }
    }
    return guide;
}

}  // namespace suture::algebraic

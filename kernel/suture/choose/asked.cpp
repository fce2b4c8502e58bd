#include "suture/choose/asked.h"

#include "suture/ribbon/noise.h"

#include <Eigen/Geometry>

#include <BRep_Tool.hxx>

#include <algorithm>
#include <cmath>

namespace suture {
namespace {

/// How two ribbons miss each other where the first ends and the second begins.
void add_corner(const Ribbon& before, const Ribbon& after, AskedSide& side) {
    const RibbonPoint a = before.at(1.0);
    const RibbonPoint b = after.at(0.0);
    side.corner_gap = std::max(side.corner_gap, (a.point - b.point).norm());
    if (is_free(before) || is_free(after)) {
        // A tangent face has to hold the curve: by how much that leaves the neighbour's plane.
        const Eigen::Vector3d normal = is_free(before) ? b.normal : a.normal;
        const Eigen::Vector3d curve = is_free(before) ? a.tangent : b.tangent;
        if (is_free(before) != is_free(after)) {
            side.corner_angle =
                std::max(side.corner_angle,
                         std::asin(std::min(1.0, std::abs(normal.dot(curve.normalized())))));
        }
        return;
    }
    side.corner_angle = std::max(
        side.corner_angle, std::atan2(a.normal.cross(b.normal).norm(), a.normal.dot(b.normal)));
}

}  // namespace

AskedFill asked_of(const std::vector<BoundaryLoop>& loops, const Hole& hole,
                   const std::vector<Wish>& wishes, const Tolerance& tolerance) {
    AskedFill asked;
    const std::vector<double> noise = noise_of_sides(loops, hole);
    asked.hole = loops.front().id;
    asked.diameter = hole.diameter;
    asked.tolerance = tolerance;
    for (std::size_t l = 0; l < hole.loops.size(); ++l) {
        const std::vector<Ribbon>& ribbons = hole.loops[l].ribbons;
        const std::size_t n = ribbons.size();
        for (std::size_t i = 0; i < n; ++i) {
            AskedSide side;
            side.edge = ribbons[i].edge;
            side.alone = loops[l].edges[i].face.IsNull();
            side.supported = !loops[l].edges[i].support.IsNull();
            side.continuity = ribbons[i].continuity;
            side.tolerance = BRep_Tool::Tolerance(loops[l].edges[i].edge);
            side.noise = noise[asked.sides.size()];
            add_corner(ribbons[(i + n - 1) % n], ribbons[i], side);
            add_corner(ribbons[i], ribbons[(i + 1) % n], side);
            if (!wishes.empty()) {
                const Wish& wish = wishes[asked.sides.size()];
                side.given_up = wish.given_up;
                side.wall = wish.wall;
            }
            asked.sides.push_back(side);
        }
    }
    return asked;
}

void account_for(const FillResult& fill, bool recognised, const std::optional<TwinFigures>& twin,
                 AskedFill& asked) {
    asked.closed_form = std::none_of(
        fill.patches.begin(), fill.patches.end(),
        [](const Patch& patch) { return std::holds_alternative<SplineSurface>(patch.surface); });
    asked.recognised = recognised;
    asked.twin_folds = twin && twin->folds;
    for (std::size_t i = 0; i < asked.sides.size(); ++i) {
        asked.sides[i].of_twin = twin ? twin->angles[i] : std::nullopt;
    }
}

}  // namespace suture

#include "suture/fill/concentric.h"

#include "suture/fill/concentric/assemble.h"
#include "suture/fill/concentric/boundary.h"
#include "suture/fill/concentric/lift.h"
#include "suture/fill/concentric/map.h"
#include "suture/fill/concentric/paper_map.h"
#include "suture/fill/concentric/stubs.h"
#include "suture/fill/concentric/sweep.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>

namespace suture {
namespace {

using concentric::Boundary;
using concentric::ConcentricMap;
using concentric::Region;
using Eigen::Vector3d;

/// What is no polynomial is fitted to this share of the length tolerance: the new face then keeps
/// to its edges as well as a STEP file says where they are.
constexpr double kFitShare = 1e-4;

/// Branches of the axis that stand out less, and nodes that bend it less, as shares of the largest
/// inscribed circle's radius: a cap wants few control points.
constexpr double kSalience = 0.1;
constexpr double kFlatness = 0.02;

/// A side that leaves the plane of its neighbour at a corner by more cannot be met beside it.
constexpr double kMostOut = radians(30.0);

/// Refuses  a neighbour out of whose tangent plane the next side runs at a corner, naming it.
Result<void> check_corners(const Hole& hole) {
    const auto& ribbons = hole.loops.front().ribbons;
    const std::size_t n = ribbons.size();
    for (std::size_t i = 0; n > 1 && i < n; ++i) {
        for (const int end : {0, 1}) {
            const Ribbon& beside = ribbons[(i + (end == 0 ? n - 1 : 1)) % n];
            const Vector3d along = beside.at(1.0 - end).tangent.normalized();
            const double out =
                std::asin(std::clamp(std::abs(ribbons[i].at(end).normal.dot(along)), 0.0, 1.0));
            if (ribbons[i].continuity >= Continuity::G1 && out > kMostOut) {
                return fail(
                    ErrorCode::Refused,
                    "{} leaves the tangent plane of the neighbour at {} by {:.1f} deg where "
                    "they meet (limit {:.0f}): no surface is tangent there",
                    name_of(beside), name_of(ribbons[i]), degrees(out), degrees(kMostOut));
            }
        }
    }
    return {};
}

/// An error that speaks of parameters: s = 2.3 is on the third side.
Error named_after_sides(const Error& error, const Hole& hole) {
    const auto& ribbons = hole.loops.front().ribbons;
    return {error.code, fmt::format("{}; s counts the sides from {} on", error.message,
                                    name_of(ribbons.front()))};
}

/// Whether the loop and all that it has to be tangent to lie in one plane.
bool is_flat(const Hole& hole, const Boundary& boundary, const Tolerance& tolerance) {
    if (boundary.height > tolerance.linear) {
        return false;
    }
    const auto& ribbons = hole.loops.front().ribbons;
    return std::all_of(ribbons.begin(), ribbons.end(), [&](const Ribbon& ribbon) {
        constexpr int kProbes = 8;
        for (int k = 0; ribbon.continuity >= Continuity::G1 && k <= kProbes; ++k) {
            const Vector3d normal = ribbon.at(static_cast<double>(k) / kProbes).normal;
            if (normal.cross(boundary.frame.z).norm() > tolerance.angular) {
                return false;
            }
        }
        return true;
    });
}

/// The map itself: bidegree (p, 1).
FillResult fill_flat(const Boundary& boundary, concentric::ConcentricCurve& axis,
                     std::optional<int> single) {
    const std::vector<Region> regions = concentric::regions_of(boundary, axis, single);
    const auto vertex = [&](int node) {
        return boundary.lifted(axis.nodes[static_cast<std::size_t>(node)]);
    };
    const auto surface = [&](const Region& region) {
        SplineCurve row = concentric::linear_spline(region.courses, axis.nodes);
        Eigen::MatrixXd lifted(3, row.count());
        for (int k = 0; k < row.count(); ++k) {
            lifted.col(k) = boundary.lifted(row.poles.col(k));
        }
        row.poles = std::move(lifted);
        SplineCurve side = region.side;
        concentric::make_compatible(side, row);
        concentric::collapse_rests(row, region.courses, vertex);
        return concentric::from_rows({side, row}, {0.0, 0.0, 1.0, 1.0});
    };
    FillResult result = concentric::assemble(regions, surface, vertex);
    for (Patch& patch : result.patches) {
        patch.exact = boundary.error <= 0.0;
        patch.fit_error = boundary.error;
    }
    return result;
}

/// The map lifted into space along a guide.
FillResult fill_curved(const Hole& hole, const Boundary& boundary, const concentric::Guide& guide,
                       concentric::ConcentricCurve& axis, std::optional<int> single,
                       const Tolerance& tolerance) {
    // Corners get their nodes first: then every course keeps its ends.
    for (int i = 0; i < boundary.count(); ++i) {
        concentric::insert_node(axis, i);
    }
    const std::vector<Region> regions = concentric::regions_of(boundary, axis, single);
    concentric::Lift lift(hole, boundary, guide, axis, regions, tolerance);
    FillResult result = concentric::assemble(
        regions, [&](const Region& region) { return lift.surface(region); },
        [&](int node) { return lift.vertex(node); });
    for (Patch& patch : result.patches) {
        patch.exact = false;
        patch.fit_error = std::max(boundary.error, lift.error());
    }
    result.notes = guide.notes;
    if (lift.missed() > 1.0) {
        result.notes.push_back(
            fmt::format("the lifted faces miss their guide by {:.2g} times what is wanted: they "
                        "may meet at larger angles",
                        lift.missed()));
    }
    return result;
}

Result<ConcentricMap> map_of(const concentric::ClosedSpline& loop, const FillOptions& options,
                             bool single) {
    const std::string_view axis = find_word(options.own, "axis").value_or("certified");
    if (axis != "certified") {
        using concentric::PaperAxis;
        return concentric::paper_map(loop, axis == "basic" ? PaperAxis::Basic : PaperAxis::Moved);
    }
    concentric::MapOptions map_options;
    map_options.salience = find_number(options.own, "salience").value_or(kSalience);
    map_options.flatness = find_number(options.own, "flatness").value_or(kFlatness);
    // OCCT does not read a face from STEP whose border meets itself in points at such places.
    map_options.rest_between_corners = !single;
    map_options.rest_at_tips = true;
    return concentric::concentric_map(loop, map_options);
}

std::string note(const ConcentricMap& map, bool flat) {
    return fmt::format(
        "{} map over a medial axis of {} nodes, its control polygon refined {} times",
        flat ? "planar" : "lifted", concentric::used_nodes(map.axis), map.refinements);
}

}  // namespace

std::span<const MethodOption> concentric_options() {
    static constexpr std::array kOptions = {
        MethodOption{"faces", OptionKind::Word, "regions|one",
                     "one face for each side of the hole, or one for all; default regions"},
        MethodOption{"axis", OptionKind::Word, "certified|basic|moved",
                     "the axis: one whose map is proved not to fold; the paper's own; the paper's, "
                     "moved onto that of a refined control polygon; default certified"},
        MethodOption{"salience", OptionKind::Number, "SHARE",
                     "cut branches of the axis that stand out less, as a share of the largest "
                     "inscribed circle's radius; default 0.1",
                     0.0},
        MethodOption{"flatness", OptionKind::Number, "SHARE",
                     "drop nodes of the axis that bend it less, likewise; default 0.02", 0.0},
    };
    return kOptions;
}

Result<FillResult> fill_concentric(const Hole& hole, const FillOptions& options) {
    if (!hole.through.empty()) {
        return fail(ErrorCode::Refused,
                    "there are {} points to pass through: the spokes leave no freedom for them",
                    hole.through.size());
    }
    const auto boundary = concentric::boundary_of(hole, kFitShare * options.tolerance.linear);
    if (!boundary) {
        return tl::unexpected(boundary.error());
    }
    const bool flat = is_flat(hole, *boundary, options.tolerance);
    std::optional<concentric::Guide> guide;
    if (!flat) {
        if (const auto corners = check_corners(hole); !corners) {
            return tl::unexpected(corners.error());
        }
        auto found = concentric::guide_of(hole, options);
        if (!found) {
            return tl::unexpected(found.error());
        }
        guide = std::move(*found);
    }
    const concentric::ClosedSpline& loop = flat ? boundary->planar : guide->loop;
    const bool single = find_word(options.own, "faces").value_or("regions") == "one";
    auto map = map_of(loop, options, single);
    if (!map) {
        return tl::unexpected(named_after_sides(map.error(), hole));
    }
    std::optional<int> first;
    if (single) {
        auto opened = concentric::with_stubs(map->axis, loop, boundary->count());
        map->axis = std::move(opened.axis);
        first = opened.side;
    }
    FillResult result =
        flat ? fill_flat(*boundary, map->axis, first)
             : fill_curved(hole, *boundary, *guide, map->axis, first, options.tolerance);
    result.notes.push_back(note(*map, flat));
    return result;
}

}  // namespace suture

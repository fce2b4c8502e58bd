#include "suture/fill/tube.h"

#include "suture/fill/tube/border_fit.h"
#include "suture/fill/tube/divide.h"
#include "suture/fill/tube/fairing.h"
#include "suture/fill/tube/pole.h"
#include "suture/fill/tube/quality.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <memory>

namespace suture {
namespace {

using Eigen::Vector3d;

/// The parameter around is as long as a circle about the pole of radius 2, the parameter's range
/// across: a disc is run through alike in both directions at its border.
constexpr double kAround = 4.0 * kPi;

constexpr int kFewestLayers = 2;
constexpr int kMostLayers = 14;

/// Creases stay below this share of the angle tolerance: near a corner they add to the border's.
constexpr double kCrease = 0.5;

/// Where a surface turns over its normals differ by 180 deg, if samples stand near enough; those of
/// the paper's figure 8, with tangents that are too long, turn by 92 and do not.
constexpr double kMostTurn = radians(120.0);

/// Layers become narrower by halves: beyond this, than what doubles tell apart at the border.
constexpr int kMostLayersGiven = 24;

/// Where the columns come from and where they end.
struct Aim {
    tube::Radials radials;
    tube::Pole pole;
};

struct Tube {
    tube::Fairing fairing;
    double gap = 0.0, angle = 0.0, crease = 0.0;
    int layers = 0;
};

/// A value for each patch around, from one for each side.
std::vector<double> by_patch(const std::vector<double>& by_side, const tube::Divisions& divisions) {
    if (by_side.size() <= 1) {
        return by_side;
    }
    std::vector<double> values;
    for (std::size_t side = 0; side < divisions.size(); ++side) {
        values.insert(values.end(), divisions[side].size(), by_side[side]);
    }
    return values;
}

Result<tube::FairingTask> task_of(const OptionValues& own, const tube::Pole& pole,
                                  const tube::BorderRows& rows, const tube::Divisions& divisions) {
    tube::FairingTask task;
    const auto directions = tube::directions_at(pole, rows.points, rows.outward, rows.plane);
    if (!directions) {
        return tl::unexpected(directions.error());
    }
    task.closing = {pole.point, pole.normal, *directions};
    const auto word = find_word(own, "energy").value_or("plate");
    task.functional = word == "F1"   ? tube::Functional::F1
                      : word == "F2" ? tube::Functional::F2
                      : word == "F3" ? tube::Functional::F3
                                     : tube::Functional::Plate;
    if (const auto magnitude = find_number(own, "magnitude")) {
        task.magnitudes.emplace(directions->size(), *magnitude);
    }
    if (const auto weight = find_number(own, "move-pole")) {
        task.moving = tube::PoleWeight{*weight, /*relative=*/true};
    }
    task.curvatures = by_patch(find_numbers(own, "curvature"), divisions);
    return task;
}

tube::Way way_of(const OptionValues& own) {
    using Pieces = tube::Way::Pieces;
    const auto word = find_word(own, "border").value_or("interpolated");
    return {word == "bezier"   ? Pieces::Bezier
            : word == "taylor" ? Pieces::Taylor
                               : Pieces::Interpolated,
            find_word(own, "join").value_or("fit") == "march" ? tube::Way::Join::Marching
                                                              : tube::Way::Join::AllAtOnce};
}

/// Where the columns end in the plane: as laid out, else in their directions at the pole as far
/// away as they are in space.
Eigen::Matrix2Xd in_plane(const tube::Closing& closing, const tube::BorderRows& rows) {
    if (rows.plane.cols() > 0) {
        return rows.plane;
    }
    const Vector3d x = closing.normal.unitOrthogonal();
    const Vector3d y = closing.normal.cross(x);
    Eigen::Matrix2Xd plane(2, rows.points.cols());
    for (Eigen::Index j = 0; j < plane.cols(); ++j) {
        const Vector3d& direction = closing.directions[static_cast<std::size_t>(j)];
        plane.col(j) = (rows.points.col(j) - closing.pole).norm() *
                       Eigen::Vector2d(direction.dot(x), direction.dot(y));
    }
    return plane;
}

Result<Aim> take_aim(const Hole& hole, const OptionValues& own,
                     const std::optional<Vector3d>& point) {
    const RibbonLoop& loop = hole.loops.front();
    auto radials = point ? tube::Radials::from_point(loop, *point)
                         : tube::Radials::developed(loop, hole.diameter);
    if (!radials) {
        return tl::unexpected(radials.error());
    }
    const auto pole = tube::find_pole(loop, *radials, point, find_vector(own, "normal"));
    if (!pole) {
        return tl::unexpected(pole.error());
    }
    return Aim{std::move(*radials), *pole};
}

/// The tube with so many layers.
Result<Tube> make_tube(const RibbonLoop& loop, const Aim& aim, const OptionValues& own,
                       const Tolerance& tolerance, int layers) {
    const std::vector<double> across = tube::knots_across(layers);
    const tube::Way way = way_of(own);
    const tube::Border border(loop, aim.radials, aim.pole.point, kAround, across.back());
    const tube::Divisions divisions =
        tube::divide(border, tolerance, std::ldexp(1.0, -layers), way);
    const tube::BorderRows rows = tube::fit_border(border, divisions, tolerance, way);
    auto task = task_of(own, aim.pole, rows, divisions);
    if (!task) {
        return tl::unexpected(task.error());
    }
    tube::Net net(across, rows.ring);
    task->chart = tube::Chart::radial(net, in_plane(task->closing, rows));
    for (int j = 0; j < net.columns(); ++j) {
        net.point(net.rows() - 1, j) = rows.points.col(j);
        net.point(net.rows() - 2, j) =
            rows.points.col(j) - rows.outward.col(j) * (net.last_step() / 3.0);
    }
    auto fairing = tube::close(net, *task);
    if (!fairing) {
        return tl::unexpected(fairing.error());
    }
    Tube result{std::move(*fairing), 0.0, 0.0, 0.0, layers};
    for (const auto& side : tube::measure_border(border, divisions, rows)) {
        for (const tube::BorderError& error : side) {
            result.gap = std::max(result.gap, error.gap);
            result.angle = std::max(result.angle, error.angle);
        }
    }
    for (const tube::Crease& crease : tube::measure_creases(result.fairing.net)) {
        result.crease = std::max(result.crease, crease.angle);
    }
    return result;
}

Error folds(const tube::Net& net, const tube::Fold& fold) {
    const Vector3d at = tube::evaluate(net, fold.u, fold.interval, fold.v).point;
    return fail(ErrorCode::Refused,
                "the surface folds: its normal turns by {:.1f} deg within a patch (limit {:.0f}), "
                "near ({:.6g}, {:.6g}, {:.6g})",
                degrees(fold.turn), degrees(kMostTurn), at.x(), at.y(), at.z())
        .value();
}

/// As many layers as keep the creases small: they fall in proportion to the last layer's width.
/// What the border's columns are off by adds to them, so that a few columns less must do to find
/// out.
Result<int> find_layers(const RibbonLoop& loop, const Aim& aim, const FillOptions& options) {
    constexpr double kCoarse = 2.0;
    Tolerance coarse = options.tolerance;
    coarse.linear *= kCoarse;
    coarse.angular *= kCoarse;
    const double limit = kCrease * options.tolerance.angular;
    OptionValues own = options.own;
    own.erase("curvature");  // at the pole, far from the border's layers
    for (int layers = kFewestLayers;;) {
        if (options.progress.cancelled()) {
            return fail(ErrorCode::Cancelled, "stopped while filling");
        }
        const auto tube = make_tube(loop, aim, own, coarse, layers);
        if (!tube) {
            return tl::unexpected(tube.error());
        }
        const tube::Fold fold = tube::measure_fold(tube->fairing.net, aim.pole.normal);
        if (fold.turn > kMostTurn) {
            return tl::unexpected(folds(tube->fairing.net, fold));
        }
        if (tube->crease <= limit || layers >= kMostLayers) {
            return layers;
        }
        const int more = static_cast<int>(std::ceil(std::log2(tube->crease / limit)));
        layers = std::min(layers + std::max(more, 1), kMostLayers);
    }
}

Result<void> expect_treatable(const Hole& hole, const FillOptions& options) {
    if (hole.loops.size() != 1) {
        return fail(ErrorCode::Refused, "the hole has {} loops: a tube closes one",
                    hole.loops.size());
    }
    if (!hole.through.empty()) {
        return fail(ErrorCode::Refused, "the tube passes no inner points: {} were given",
                    hole.through.size());
    }
    constexpr double kShortest = 1e-6;
    for (const Ribbon& ribbon : hole.loops.front().ribbons) {
        const double length = tube::Course(ribbon).length();
        if (!(length > kShortest * hole.diameter)) {
            return fail(ErrorCode::Refused, "{} is {:.3g} long, {:g} of the diameter (limit {:g})",
                        name_of(ribbon), length, length / hole.diameter, kShortest);
        }
    }
    if (const int layers = find_count(options.own, "layers").value_or(0);
        layers > kMostLayersGiven) {
        return fail(ErrorCode::Refused, "{} layers were asked for, at most {} can be told apart",
                    layers, kMostLayersGiven);
    }
    const auto curvatures = find_numbers(options.own, "curvature").size();
    const auto sides = hole.loops.front().ribbons.size();
    if (curvatures > 1 && curvatures != sides) {
        return fail(ErrorCode::Refused, "{} curvatures were given for {} sides", curvatures, sides);
    }
    return {};
}

/// One patch with a seam from the first corner to the pole.
FillResult lay_out(const tube::Net& net, const RibbonLoop& loop, const Aim& aim) {
    Patch patch;
    patch.surface = tube::to_surface(net);
    const auto border = std::make_shared<const tube::Border>(loop, aim.radials, aim.pole.point,
                                                             kAround, net.border());
    std::vector<TrimCurve> trims;
    trims.reserve(static_cast<std::size_t>(border->sides()));
    for (int side = 0; side < border->sides(); ++side) {
        trims.emplace_back([border, side, u = net.border()](double s) -> Eigen::Vector2d {
            return {u, s == 1.0 ? border->start(side + 1)
                                : border->start(side) + border->v_of(side, s)};
        });
    }
    std::vector<EdgeUse>& wire = patch.wires.emplace_back(wire_of_loop(0, std::move(trims)));
    const auto seam = [u = net.border()](double v) -> TrimCurve {
        return [u, v](double s) -> Eigen::Vector2d { return {u * (1.0 - s), v}; };
    };
    wire.push_back({-1, 0, false, seam(kAround), /*pole_after=*/true});
    wire.push_back({-1, 0, true, seam(0.0)});
    FillResult result;
    result.inner_vertices = {evaluate(patch.surface, 0.0, 0.0).point};
    result.inner_edges = {{{0, 0}, {-1, 0}}};
    result.patches.push_back(std::move(patch));
    return result;
}

}  // namespace

namespace {

Result<FillResult> fill_from(const Hole& hole, const FillOptions& options, const Aim& aim) {
    const RibbonLoop& loop = hole.loops.front();
    const auto given = find_count(options.own, "layers");
    const auto layers = given ? Result<int>(*given) : find_layers(loop, aim, options);
    if (!layers) {
        return tl::unexpected(layers.error());
    }
    const auto tube = make_tube(loop, aim, options.own, options.tolerance, *layers);
    if (!tube) {
        return tl::unexpected(tube.error());
    }
    const tube::Net& net = tube->fairing.net;
    const tube::Fold fold = tube::measure_fold(net, aim.pole.normal);
    if (fold.turn > kMostTurn) {
        return tl::unexpected(folds(tube->fairing.net, fold));
    }
    FillResult result = lay_out(net, loop, aim);
    result.notes.push_back(fmt::format(
        "{} x {} poles, closed at ({:.6g}, {:.6g}, {:.6g}); at ribbon samples between the fitted "
        "ones: gap {:.2g}, angle {:.2g} deg; crease along the corners' lines {:.2g} deg",
        net.rows(), net.columns(), tube->fairing.pole.x(), tube->fairing.pole.y(),
        tube->fairing.pole.z(), tube->gap, degrees(tube->angle), degrees(tube->crease)));
    return result;
}

}  // namespace

Result<FillResult> fill_tube(const Hole& hole, const FillOptions& options) {
    if (const auto treatable = expect_treatable(hole, options); !treatable) {
        return tl::unexpected(treatable.error());
    }
    const auto point = find_vector(options.own, "pole");
    const auto aim = take_aim(hole, options.own, point);
    if (!aim) {
        return tl::unexpected(aim.error());
    }
    auto fill = fill_from(hole, options, *aim);
    if (fill || point || fill.error().code != ErrorCode::Refused) {
        return fill;
    }
    // The radials of the layout do not suit: those seen from the same point in space may.
    const auto seen = take_aim(hole, options.own, aim->pole.point);
    if (!seen) {
        return fill;
    }
    auto again = fill_from(hole, options, *seen);
    return again ? again : fill;
}

}  // namespace suture

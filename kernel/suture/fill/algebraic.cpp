#include "suture/fill/algebraic.h"

#include "suture/fill/algebraic/guide.h"
#include "suture/fill/algebraic/jets.h"
#include "suture/fill/algebraic/neighbour.h"
#include "suture/fill/algebraic/parse.h"
#include "suture/fill/algebraic/patches.h"
#include "suture/fill/algebraic/solution.h"
#include "suture/fill/algebraic/view.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>

namespace suture {
namespace {

using algebraic::Problem;
using algebraic::Search;
using algebraic::SideShape;
using algebraic::Solution;
using algebraic::Unit;
using Eigen::Vector3d;

/// The faces may use up so much of the tolerance: edges and neighbours have errors of their own.
constexpr double kShareOfTolerance = 0.2;
/// A gap below this share of the diameter is asked for in any case.
constexpr double kGap = 2e-7;
/// How far a curve may leave its plane, of the tolerance.
constexpr double kPlanar = 0.1;

Result<void> expect_simple(const Hole& hole) {
    if (hole.loops.size() != 1) {
        return fail(ErrorCode::Refused, "the hole has {} islands; space is divided around one loop",
                    hole.loops.size() - 1);
    }
    const auto& ribbons = hole.loops.front().ribbons;
    if (ribbons.size() < 3) {
        return fail(ErrorCode::Refused, "{}: the hole has {} sides; cells around an axis need 3",
                    name_of(ribbons.front()), ribbons.size());
    }
    if (!hole.through.empty()) {
        return fail(ErrorCode::Refused, "points to pass through are not part of this method");
    }
    return {};
}

/// How smoothly each side is to be met.
std::vector<int> orders(const std::vector<Ribbon>& ribbons, const OptionValues& own) {
    std::vector<int> result;
    result.reserve(ribbons.size());
    for (const Ribbon& ribbon : ribbons) {
        result.push_back(find_count(own, "k").value_or(static_cast<int>(ribbon.continuity)));
    }
    return result;
}

/// Polynomials are smooth at a corner, so that both neighbours must have the same normal there.
Result<void> expect_compatible(const std::vector<Ribbon>& ribbons, const std::vector<int>& k,
                               double angular) {
    for (std::size_t i = 0; i < ribbons.size(); ++i) {
        const std::size_t before = (i + ribbons.size() - 1) % ribbons.size();
        const Vector3d a = ribbons[before].at(1.0).normal;
        const Vector3d b = ribbons[i].at(0.0).normal;
        const double angle = std::atan2(a.cross(b).norm(), a.dot(b));
        if (k[i] > 0 && k[before] > 0 && angle > angular) {
            return fail(ErrorCode::Refused,
                        "the normals of the neighbours differ by {:.3g} deg where {} and {} meet, "
                        "more than {:.3g}",
                        degrees(angle), name_of(ribbons[before]), name_of(ribbons[i]),
                        degrees(angular));
        }
    }
    return {};
}

Unit unit_of(const Hole& hole) {
    constexpr int kSamples = 8;
    const auto& ribbons = hole.loops.front().ribbons;
    Unit unit;
    for (const Ribbon& ribbon : ribbons) {
        for (int n = 0; n < kSamples; ++n) {
            unit.origin += ribbon.at(static_cast<double>(n) / kSamples).point;
        }
    }
    unit.origin /= static_cast<double>(ribbons.size()) * kSamples;
    unit.size = 0.5 * hole.diameter;
    return unit;
}

/// The plane through a straight side and the centre.
algebraic::Polynomial<double> plane_of(const algebraic::UnitCurve& curve, const Vector3d& centre) {
    const Vector3d normal = (curve(0.0) - centre).cross(curve(1.0) - centre).normalized();
    return algebraic::Polynomial<double>::linear({normal.x(), normal.y(), normal.z()},
                                                 -normal.dot(centre));
}

Result<Problem> pose(const Hole& hole, const FillOptions& options, const Unit& unit) {
    const auto& ribbons = hole.loops.front().ribbons;
    const std::vector<int> k = orders(ribbons, options.own);
    const double planar = std::max(kPlanar * options.tolerance.linear, hole.tolerance);
    Problem problem;
    problem.interface_k = *std::max_element(k.begin(), k.end());
    std::vector<SideShape> shapes;
    for (std::size_t i = 0; i < ribbons.size(); ++i) {
        const Ribbon& ribbon = ribbons[i];
        const auto form = implicit_form(ribbon, unit, planar);
        if (!form) {
            return tl::unexpected(form.error());
        }
        const auto shape = shape_of(ribbon, unit, planar);
        if (!shape) {
            return tl::unexpected(shape.error());
        }
        problem.sides.push_back({*form, shape->plane, k[i]});
        shapes.push_back(*shape);
        problem.curves.push_back([at = ribbon.at, unit](double s) { return unit.in(at(s).point); });
    }
    if (const auto compatible = expect_compatible(ribbons, k, options.tolerance.angular);
        !compatible) {
        return tl::unexpected(compatible.error());
    }
    auto guide = algebraic::guide_by_mvs(hole, unit, options);
    if (!guide) {
        return tl::unexpected(guide.error());
    }
    problem.guide = std::move(*guide);
    const auto view = find_view(problem.curves, shapes, problem.guide);
    if (!view) {
        return tl::unexpected(view.error());
    }
    problem.view = *view;
    for (std::size_t i = 0; i < ribbons.size(); ++i) {
        if (shapes[i].straight) {
            problem.sides[i].F = plane_of(problem.curves[i], view->centre);
        }
    }
    return problem;
}

Search search_for(const OptionValues& own) {
    Search search;
    search.degree = find_count(own, "degree");
    if (const auto cells = find_word(own, "cells")) {
        search.inner_cells = *cells == "inner";
    }
    return search;
}

/// The largest angle between grad g and the neighbours' normals along the sides: what rounding and
/// the model's own noise leave of the identities.
double angle_at_sides(const Hole& hole, const Unit& unit, const Solution& solution) {
    constexpr int kSamples = 33;
    double most = 0.0;
    const auto& ribbons = hole.loops.front().ribbons;
    for (std::size_t i = 0; i < ribbons.size(); ++i) {
        for (int n = 0; n < kSamples; ++n) {
            const RibbonPoint p = ribbons[i].at(static_cast<double>(n) / (kSamples - 1));
            const Vector3d gradient = evaluate(solution.cells[i], unit.in(p.point)).gradient;
            most =
                std::max(most, std::atan2(gradient.cross(p.normal).norm(), gradient.dot(p.normal)));
        }
    }
    return most;
}

ImplicitForm implicit_form_of(const Problem& problem, const Solution& solution, const Unit& unit) {
    ImplicitForm form{unit.origin, unit.size, problem.view.centre, solution.degree, {}};
    for (const algebraic::Polynomial<double>& cell : solution.cells) {
        form.cells.push_back({algebraic::to_text(cell), {}});
    }
    for (const algebraic::Sector& sector : solution.partition.sectors) {
        form.cells[static_cast<std::size_t>(sector.cell)].cones.push_back(
            algebraic::directions_of(sector, solution.rays));
    }
    return form;
}

std::string describe(const Solution& s) {
    std::string text = fmt::format(
        "degree {} in {} cells: {} x {} system, rank {}, {} solutions, {} different surfaces; "
        "{}single sheet proven",
        s.degree, s.partition.cells, s.rows, s.columns, s.rank, s.dimension, s.polynomials,
        s.guided_only ? "" : "chosen under conditions, ");
    if (s.slope > 0.0) {
        text += fmt::format(", gradient at least {:.3g} of the neighbours'", s.slope);
    }
    return text;
}

}  // namespace

std::span<const MethodOption> algebraic_options() {
    static constexpr std::array kOptions = {
        MethodOption{"k", OptionKind::Count, "K",
                     "G^k with all neighbours and between cells (default: as each side asks for)",
                     0.0},
        MethodOption{"degree", OptionKind::Count, "D",
                     "degree of the polynomials (default: the lowest that works)", 1.0},
        MethodOption{"cells", OptionKind::Word, "axis|inner",
                     "cells around an axis, or with inner cells (default: the fewest that work)"},
    };
    return kOptions;
}

Result<FillResult> fill_algebraic(const Hole& hole, const FillOptions& options) {
    if (const auto simple = expect_simple(hole); !simple) {
        return tl::unexpected(simple.error());
    }
    const Unit unit = unit_of(hole);
    const auto problem = pose(hole, options, unit);
    if (!problem) {
        return tl::unexpected(problem.error());
    }
    const auto solution = find_solution(*problem, search_for(options.own), options.progress);
    if (!solution) {
        return tl::unexpected(solution.error());
    }
    Tolerance goal = options.tolerance;
    goal.linear = std::min(kShareOfTolerance * goal.linear, kGap * hole.diameter);
    goal.angular *= kShareOfTolerance;
    algebraic::FitReport report;
    auto result = make_patches(*problem, *solution, unit, goal, options.progress, report);
    if (!result) {
        return result;
    }
    result->implicit = implicit_form_of(*problem, *solution, unit);
    result->notes.push_back(describe(*solution));
    result->notes.push_back(fmt::format(
        "the polynomials meet the neighbours' normals within {:.2g} deg; the faces lie within "
        "{:.2g} and {:.2g} deg of the polynomials",
        degrees(angle_at_sides(hole, unit, *solution)), report.distance, degrees(report.angle)));
    return result;
}

}  // namespace suture

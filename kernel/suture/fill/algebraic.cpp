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
/// How far a member may miss the edges, of the tolerance.
constexpr double kShareOfGap = 0.5;
/// How far a member's normals may be off those of the neighbours, of the tolerance.
constexpr double kShareOfAngle = 0.8;
/// A member that is smooth at a corner shares out what the neighbours differ by there.
constexpr double kShareOfNoise = 2.0;
/// Neighbours whose normals differ by more at a corner are different surfaces; as for the judge.
constexpr double kMostNoise = radians(1.0);
/// Jets along a side: several times as many as a polynomial of degree 7 can tell apart there.
constexpr int kJets = 65;
/// Ribbons know no more than curvature.
constexpr int kMostByJets = 2;

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

/// How far the normals of two neighbours that should agree at a corner differ: how exact the model
/// is.
///
/// Refuses  a corner where they differ by more: polynomials are smooth there.
Result<double> noise_of_corners(const std::vector<Ribbon>& ribbons, const std::vector<int>& k) {
    double noise = 0.0;
    for (std::size_t i = 0; i < ribbons.size(); ++i) {
        const std::size_t before = (i + ribbons.size() - 1) % ribbons.size();
        const Vector3d a = ribbons[before].at(1.0).normal;
        const Vector3d b = ribbons[i].at(0.0).normal;
        const double angle = std::atan2(a.cross(b).norm(), a.dot(b));
        if (k[i] == 0 || k[before] == 0) {
            continue;
        }
        if (angle > kMostNoise) {
            return fail(ErrorCode::Refused,
                        "the normals of the neighbours differ by {:.3g} deg where {} and {} meet, "
                        "more than {:.3g}",
                        degrees(angle), name_of(ribbons[before]), name_of(ribbons[i]),
                        degrees(kMostNoise));
        }
        noise = std::max(noise, angle);
    }
    return noise;
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

/// The jets of a side as the hole is.
algebraic::SideJets jets_of(const Ribbon& ribbon, const Unit& unit, int k) {
    algebraic::SideJets side;
    side.k = k;
    for (int n = 0; n < kJets; ++n) {
        const RibbonPoint p = ribbon.at(static_cast<double>(n) / (kJets - 1));
        side.jets.push_back({unit.in(p.point), p.normal, p.inward, unit.size * p.curvature});
    }
    return side;
}

/// More than curvature is known only of a neighbour with an equation, along a planar edge.
Result<algebraic::Side<double>> polynomial_side(const Ribbon& ribbon, const SideShape& shape,
                                                const Unit& unit, int k) {
    const auto f = algebraic::equation_of(ribbon, unit);
    if (!f) {
        return fail(ErrorCode::Refused,
                    "{}: G^{} asks for a neighbour with an equation: a plane, cylinder, cone, "
                    "sphere or torus",
                    name_of(ribbon), k);
    }
    if (!shape.straight && !shape.plane) {
        return fail(ErrorCode::Refused, "{} is not planar, which G^{} asks for", name_of(ribbon),
                    k);
    }
    return algebraic::Side<double>{*f, shape.plane.value_or(algebraic::Polynomial<double>()), k};
}

Result<Problem> pose(const Hole& hole, const FillOptions& options, const Unit& unit) {
    const auto& ribbons = hole.loops.front().ribbons;
    const std::vector<int> k = orders(ribbons, options.own);
    const double planar = std::max(kPlanar * options.tolerance.linear, hole.tolerance);
    const auto noise = noise_of_corners(ribbons, k);
    if (!noise) {
        return tl::unexpected(noise.error());
    }
    Problem problem;
    problem.interface_k = *std::max_element(k.begin(), k.end());
    problem.at_sides.linear =
        std::max(kShareOfGap * options.tolerance.linear, hole.tolerance) / unit.size;
    problem.at_sides.angular =
        std::max(kShareOfAngle * options.tolerance.angular, kShareOfNoise * *noise);
    std::vector<SideShape> shapes;
    for (std::size_t i = 0; i < ribbons.size(); ++i) {
        shapes.push_back(shape_of(ribbons[i], unit, planar));
        if (problem.interface_k <= kMostByJets) {
            problem.jets.push_back(jets_of(ribbons[i], unit, k[i]));
        } else {
            auto side = polynomial_side(ribbons[i], shapes[i], unit, k[i]);
            if (!side) {
                return tl::unexpected(side.error());
            }
            problem.sides.push_back(std::move(*side));
        }
        problem.curves.push_back(
            [at = ribbons[i].at, unit](double s) { return unit.in(at(s).point); });
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
    for (std::size_t i = 0; i < problem.sides.size(); ++i) {
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

std::string describe(const Solution& s, const Unit& unit) {
    std::string text = fmt::format(
        "degree {} in {} cells: {} x {} system, rank {}, {} solutions, {} different surfaces; "
        "{}single sheet {}",
        s.degree, s.partition.cells, s.rows, s.columns, s.rank, s.dimension, s.polynomials,
        s.guided_only ? "" : "chosen under conditions, ",
        s.proven ? "proven"
                 : fmt::format("not proven, but seen on sampled rays within {:.2g} of the guide",
                               s.seen * unit.size));
    if (s.proven && s.slope > 0.0) {
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
    Tolerance limit = options.tolerance;
    limit.angular *= kShareOfAngle;
    algebraic::FitReport report;
    auto result = make_patches(*problem, *solution, unit, goal, limit, options.progress, report);
    if (!result) {
        return result;
    }
    result->implicit = implicit_form_of(*problem, *solution, unit);
    result->notes.push_back(describe(*solution, unit));
    result->notes.push_back(fmt::format(
        "the polynomials meet the neighbours' normals within {:.2g} deg; the faces lie within "
        "{:.2g} and {:.2g} deg of the polynomials",
        degrees(angle_at_sides(hole, unit, *solution)), report.distance, degrees(report.angle)));
    return result;
}

}  // namespace suture

#include "suture/fill/algebraic/exact_problem.h"

#include "suture/fill/algebraic/jets.h"
#include "suture/fill/algebraic/parse.h"

#include <Eigen/Geometry>

#include <cmath>

namespace suture::algebraic {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

Vector3d as_vector(const Point<Rational>& p) {
    return {p[0].convert_to<double>(), p[1].convert_to<double>(), p[2].convert_to<double>()};
}

Result<void> expect_fitting(const ExactProblem& p) {
    const std::size_t n = p.sides.size();
    if (n < 3 || p.corners.size() != n) {
        return fail(ErrorCode::Usage, "{} sides and {} corners: at least 3, and as many of both", n,
                    p.corners.size());
    }
    for (std::size_t i = 0; i < n; ++i) {
        if (p.sides[i].F.degree != 1 || evaluate(p.sides[i].F, p.centre) != 0) {
            return fail(ErrorCode::Usage, "plane {} does not go through the centre", i + 1);
        }
        for (const std::size_t c : {i, (i + 1) % n}) {
            if (evaluate(p.sides[i].f, p.corners[c]) != 0 ||
                evaluate(p.sides[i].F, p.corners[c]) != 0) {
                return fail(ErrorCode::Usage, "corner {} does not lie on surface and plane {}",
                            c + 1, i + 1);
            }
        }
    }
    return {};
}

/// The curve f = 0 on the rays from the centre (the origin) between two corners, by continuation.
Result<UnitCurve> trace(const Polynomial<double>& f, const Vector3d& a, const Vector3d& b,
                        std::size_t side) {
    constexpr int kSteps = 64;
    constexpr int kNewton = 30;
    const auto refine = [f, a, b](double s, double t) {
        const Vector3d ray = (1.0 - s) * a + s * b;
        for (int n = 0; n < kNewton; ++n) {
            const ValueAndGradient at = evaluate(f, t * ray);
            const double step = at.value / at.gradient.dot(ray);
            t -= step;
            if (!(std::abs(step) > 1e-16 * std::abs(t))) {
                break;
            }
        }
        return t;
    };
    std::vector<double> table = {1.0};
    for (int n = 1; n <= kSteps; ++n) {
        table.push_back(refine(static_cast<double>(n) / kSteps, table.back()));
    }
    if (!(std::abs(table.back() - 1.0) < 1e-9)) {
        return fail(ErrorCode::Usage, "the curve of side {} does not lead to the next corner",
                    side + 1);
    }
    return UnitCurve([=](double s) -> Vector3d {
        const double at = std::clamp(s, 0.0, 1.0) * kSteps;
        const auto n = static_cast<std::size_t>(std::min(std::floor(at), kSteps - 1.0));
        const double guess = table[n] + (at - static_cast<double>(n)) * (table[n + 1] - table[n]);
        return refine(s, guess) * ((1.0 - s) * a + s * b);
    });
}

/// The ribbon along a curve of f = 0, whose gradient points outwards.
Ribbon ribbon_of(const Polynomial<double>& f, const UnitCurve& curve, int k, int number) {
    Ribbon ribbon;
    ribbon.edge = ribbon.face = number;
    ribbon.continuity = static_cast<Continuity>(std::min(k, 2));
    ribbon.at = [f, curve](double s) {
        constexpr double kStep = 1e-5;
        RibbonPoint p;
        p.point = curve(s);
        const double low = std::max(0.0, s - kStep);
        const double high = std::min(1.0, s + kStep);
        p.tangent = (curve(high) - curve(low)) / (high - low);
        p.normal = evaluate(f, p.point).gradient.normalized();
        p.inward = p.normal.cross(p.tangent).normalized();
        p.curvature = curvature(f, p.point);
        return p;
    };
    return ribbon;
}

std::vector<GuidePoint> sphere_guide(const std::vector<Vector3d>& corners, const Vector3d& outer,
                                     double radius) {
    constexpr int kDivisions = 24;
    std::vector<GuidePoint> guide;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Vector3d& next = corners[(i + 1) % corners.size()];
        for (int a = 0; a <= kDivisions; ++a) {
            for (int b = 0; a + b <= kDivisions; ++b) {
                const Vector3d ray =
                    (a * corners[i] + b * next + (kDivisions - a - b) * outer).normalized();
                guide.push_back({radius * ray, ray});
            }
        }
    }
    return guide;
}

/// The sign of each f so that its gradient points as the loop demands: the hole lies to the left.
void orient(std::vector<Polynomial<double>>& forms, const std::vector<UnitCurve>& curves,
            const Vector3d& outer) {
    for (std::size_t i = 0; i < forms.size(); ++i) {
        const Vector3d p = curves[i](0.5);
        const Vector3d tangent = curves[i](0.5 + 1e-4) - curves[i](0.5 - 1e-4);
        const Vector3d gradient = evaluate(forms[i], p).gradient;
        const double sign = gradient.cross(tangent).dot(outer - p) < 0.0 ? -1.0 : 1.0;
        forms[i] = (sign / gradient.norm()) * forms[i];
    }
}

Result<Problem> pose(const ExactProblem& given, const Unit& unit, const Progress& progress) {
    const Matrix3d scaled = unit.size * Matrix3d::Identity();
    Problem problem;
    problem.interface_k = given.k;
    std::vector<Vector3d> corners;
    for (const auto& corner : given.corners) {
        corners.push_back(unit.in(as_vector(corner)));
    }
    Vector3d outer = Vector3d::Zero();
    for (const Vector3d& corner : corners) {
        outer += corner / static_cast<double>(corners.size());
    }
    if (given.outer) {
        outer = unit.in(as_vector(*given.outer));
    }
    std::vector<Polynomial<double>> forms;
    Hole hole;
    hole.diameter = 2.0;
    hole.loops.resize(1);
    for (std::size_t i = 0; i < corners.size(); ++i) {
        forms.push_back(moved(rounded(given.sides[i].f), scaled, unit.origin));
        auto curve = trace(forms[i], corners[i], corners[(i + 1) % corners.size()], i);
        if (!curve) {
            return tl::unexpected(curve.error());
        }
        problem.curves.push_back(std::move(*curve));
    }
    orient(forms, problem.curves, outer);
    for (std::size_t i = 0; i < corners.size(); ++i) {
        Polynomial<double> plane = moved(rounded(given.sides[i].F), scaled, unit.origin);
        plane = (1.0 / coefficients(plane).tail<3>().norm()) * plane;
        problem.sides.push_back({forms[i], plane, given.k});
        hole.loops[0].ribbons.push_back(
            ribbon_of(forms[i], problem.curves[i], given.k, static_cast<int>(i) + 1));
    }
    if (given.sphere) {
        problem.guide = sphere_guide(corners, outer, *given.sphere / unit.size);
    } else {
        auto guide = guide_by_mvs(hole, Unit{}, {Tolerance{}, progress, {}});
        if (!guide) {
            return tl::unexpected(guide.error());
        }
        problem.guide = std::move(*guide);
    }
    const Vector3d normal = hole.loops[0].ribbons[0].at(0.5).normal;
    const double sign = normal.dot(problem.curves[0](0.5)) < 0.0 ? -1.0 : 1.0;
    problem.view = {Vector3d::Zero(), outer, sign, true};
    return problem;
}

/// The rational member next to the one found in doubles: in a basis in echelon form its coordinates
/// are its own coefficients at the pivots.
std::vector<Polynomial<Rational>> exact_member(const ExactSpace& space, const Solution& found,
                                               const Unit& unit) {
    const Matrix3d scaled = Matrix3d::Identity() / unit.size;
    std::vector<double> values;
    for (const Polynomial<double>& cell : found.cells) {
        const auto own = moved(cell, scaled, -unit.origin / unit.size);
        values.insert(values.end(), own.coefficients.begin(), own.coefficients.end());
    }
    std::vector<Rational> sum(values.size(), Rational(0));
    for (std::size_t n = 0; n < space.basis.size(); ++n) {
        const Rational factor(values[static_cast<std::size_t>(space.pivots[n])]);
        for (std::size_t r = 0; r < sum.size(); ++r) {
            if (space.basis[n][r] != 0) {
                sum[r] += factor * space.basis[n][r];
            }
        }
    }
    return split_cells(sum, found.degree);
}

}  // namespace

Result<ExactSolution> solve(const ExactProblem& given, const Progress& progress) {
    if (const auto fitting = expect_fitting(given); !fitting) {
        return tl::unexpected(fitting.error());
    }
    ExactSolution result;
    result.unit.origin = as_vector(given.centre);
    // A power of two, so that nothing is rounded.
    result.unit.size =
        std::exp2(std::round(std::log2((as_vector(given.corners[0]) - result.unit.origin).norm())));
    auto problem = pose(given, result.unit, progress);
    if (!problem) {
        return tl::unexpected(problem.error());
    }
    result.problem = std::move(*problem);
    auto found = find_solution(result.problem, given.search, progress);
    if (!found) {
        return tl::unexpected(found.error());
    }
    result.found = std::move(*found);
    const Partition& partition = result.found.partition;
    Point<Rational> outer = {0, 0, 0};
    for (std::size_t c = 0; c < 3; ++c) {
        for (const auto& corner : given.corners) {
            outer[c] += corner[c] / Rational(static_cast<long>(given.corners.size()));
        }
    }
    const auto points = ray_points(partition, given.corners, given.outer.value_or(outer));
    std::vector<Polynomial<Rational>> planes;
    for (const Interface& i : partition.interfaces) {
        planes.push_back(plane_through(given.centre, points[static_cast<std::size_t>(i.from)],
                                       points[static_cast<std::size_t>(i.to)]));
    }
    const ExactSpace space =
        solve_exactly(make_system(partition, given.sides, planes, given.k, result.found.degree));
    result.rank = space.rank;
    result.dimension = space.dimension;
    result.polynomials = static_cast<int>(space.basis.size());
    if (result.rank != result.found.rank) {
        return fail(ErrorCode::Refused,
                    "the rank is {} in exact arithmetic and {} in doubles: the data are too near "
                    "to a special case",
                    result.rank, result.found.rank);
    }
    result.cells = exact_member(space, result.found, result.unit);
    const Matrix3d scaled = result.unit.size * Matrix3d::Identity();
    for (std::size_t c = 0; c < result.cells.size(); ++c) {
        result.found.cells[c] = moved(rounded(result.cells[c]), scaled, result.unit.origin);
    }
    return result;
}

}  // namespace suture::algebraic

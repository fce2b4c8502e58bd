#include "suture/fill/mvs/knot_lines.h"

#include "suture/base/contract.h"
#include "suture/base/tolerance.h"
#include "suture/spline/knots.h"

#include <Eigen/Geometry>
#include <Eigen/QR>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

namespace suture::mvs {
namespace {

// Knots in a line: continuity C1 at degree 5.
constexpr int kMultiplicity = kDegree - 1;
// Corners whose normals disagree by more are not tangent to both neighbours with lines either.
constexpr double kSameNormal = radians(0.02);
// A line this near to an edge's direction leaves the hole at once, or runs beside it.
constexpr double kAlongEdge = radians(5.0);
// Part of the disagreement that may be left.
constexpr double kMet = 0.02;
// A second line has to make the jump so much smaller.
constexpr double kSecondLine = 3.0;
// What is free against what costs, in the least-norm solution.
constexpr double kFree = 1e3;
constexpr double kThreshold = 1e-8;
// The turn of the domain: how finely it is sought, what is left of a disagreement counts against
// the jumps, a line against none, and lines nearer than this make slivers.
constexpr int kTurns = 60;
constexpr double kUnmet = 1e4;
constexpr double kLineCost = 0.1;
constexpr double kSliver = 0.04;
// Corners whose lines would be nearer share one.
constexpr double kSameLine = 1e-5;
// Of the shorter side at a corner, over which the jump dies out.
constexpr double kReach = 0.8;
// Points a side for the turned layout's box.
constexpr int kBoxPoints = 48;

// A corner whose neighbours agree in normal but not in curvature.
struct TwistedCorner {
    Eigen::Vector2d uv = Eigen::Vector2d::Zero();  // in the solver's unit
    double start = 0.0;        // direction in the domain of the side that begins there
    double wedge = 0.0;        // interior angle in the domain
    double space_wedge = 0.0;  // and on the surface
    Eigen::Matrix2d twist;     // II of the side before less that of the side after, in the frame of
                               // the latter's tangent
    double shorter_side = 0.0;
};

double positive_angle(double angle) {
    const double rest = std::fmod(angle, 2.0 * kPi);
    return rest < 0.0 ? rest + 2.0 * kPi : rest;
}

// What lines in these directions, as angles from the side that begins, leave of a twist, and the
// largest jump of curvature across them:
//   II_before + a w_before^2 - II_after - b w_after^2 = sum of c_k w_k^2, least |c|,
// w the linear form that vanishes along a direction.
struct Met {
    double residual = 0.0;
    double jump = 0.0;
};
Met meet(const TwistedCorner& corner, const std::vector<double>& directions) {
    const auto square = [](double angle) {
        const double x = -std::sin(angle);
        const double y = std::cos(angle);
        return Eigen::Vector3d(x * x, std::sqrt(2.0) * x * y, y * y);
    };
    const Eigen::Matrix2d& d = corner.twist;
    const Eigen::Vector3d right(d(0, 0), std::sqrt(2.0) * d(0, 1), d(1, 1));
    const auto n = static_cast<Eigen::Index>(directions.size());
    Eigen::Matrix<double, 3, Eigen::Dynamic, 0, 3, 4> matrix(3, 2 + n);
    matrix.col(0) = -kFree * square(corner.space_wedge);
    matrix.col(1) = kFree * square(0.0);
    for (Eigen::Index k = 0; k < n; ++k) {
        matrix.col(2 + k) = square(directions[static_cast<std::size_t>(k)]);
    }
    Eigen::CompleteOrthogonalDecomposition<decltype(matrix)> solver;
    solver.setThreshold(kThreshold);
    solver.compute(matrix);
    const Eigen::VectorXd x = solver.solve(right);
    return {(matrix * x - right).norm(), n > 0 ? x.tail(n).cwiseAbs().maxCoeff() : 0.0};
}

std::optional<TwistedCorner> twisted_corner(const RibbonLoop& loop, const Layout& layout,
                                            std::size_t i, const Scale& scale) {
    const std::size_t before = (i + loop.ribbons.size() - 1) % loop.ribbons.size();
    if (std::min(loop.ribbons[before].continuity, loop.ribbons[i].continuity) < Continuity::G1) {
        return std::nullopt;
    }
    const RibbonPoint a = loop.ribbons[before].at(1.0);
    const RibbonPoint b = loop.ribbons[i].at(0.0);
    if (std::atan2(a.normal.cross(b.normal).norm(), a.normal.dot(b.normal)) > kSameNormal) {
        return std::nullopt;
    }
    TwistedCorner corner;
    const Eigen::Vector2d back = -layout.curves[before].derivative(1.0);
    const Eigen::Vector2d out = layout.curves[i].derivative(0.0);
    corner.uv = layout.curves[i].at(0.0) / scale.length;
    corner.start = std::atan2(out.y(), out.x());
    corner.wedge = positive_angle(std::atan2(back.y(), back.x()) - corner.start);
    const Eigen::Vector3d normal = (a.normal + b.normal).normalized();
    Eigen::Matrix<double, 3, 2> frame;
    frame.col(0) = b.tangent.normalized();
    frame.col(1) = normal.cross(frame.col(0));
    const Eigen::Vector2d back_in_space = -(frame.transpose() * a.tangent);
    corner.space_wedge = positive_angle(std::atan2(back_in_space.y(), back_in_space.x()));
    corner.twist = scale.length * frame.transpose() * (a.curvature - b.curvature) * frame;
    corner.shorter_side = std::min(layout.lengths[before], layout.lengths[i]) / scale.length;
    return corner;
}

std::vector<TwistedCorner> twisted_corners(const RibbonLoop& loop, const Layout& layout,
                                           const Scale& scale, double least_twist) {
    std::vector<TwistedCorner> corners;
    for (std::size_t i = 0; i < loop.ribbons.size() && loop.ribbons.size() > 1; ++i) {
        const auto corner = twisted_corner(loop, layout, i, scale);
        if (corner && meet(*corner, {}).residual > least_twist) {
            corners.push_back(*corner);
        }
    }
    return corners;
}

// The lines to take at a corner when the domain is turned by an angle: the fewest that meet the
// neighbours' forms.
struct Chosen {
    Met met;
    std::array<bool, 2> axes = {false, false};
    [[nodiscard]] int count() const { return (axes[0] ? 1 : 0) + (axes[1] ? 1 : 0); }
};

Chosen choose_lines(const TwistedCorner& corner, double turn) {
    // A whole line serves only where it parts the two sides: one half of it inside, one outside.
    std::array<std::vector<double>, 2> inside;
    for (int quarter = 0; quarter < 4; ++quarter) {
        // Quarters 0 and 2 run along u, on lines v = const: axis 1.
        const double angle = positive_angle(0.5 * kPi * quarter - turn - corner.start);
        if (angle > kAlongEdge && angle < corner.wedge - kAlongEdge) {
            inside[quarter % 2 == 0 ? 1 : 0].push_back(angle / corner.wedge * corner.space_wedge);
        }
    }
    const double enough = kMet * meet(corner, {}).residual;
    Chosen best;
    best.met = {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
    for (const std::array<bool, 2> axes : {std::array{true, false}, {false, true}, {true, true}}) {
        std::vector<double> directions;
        bool parts = true;
        for (std::size_t k = 0; k < 2; ++k) {
            if (axes[k]) {
                parts = parts && inside[k].size() == 1;
                directions.insert(directions.end(), inside[k].begin(), inside[k].end());
            }
        }
        if (!parts) {
            continue;
        }
        const Chosen tried{meet(corner, directions), axes};
        const bool meets = tried.met.residual < enough;
        const bool met = best.met.residual < enough;
        const double price = tried.count() > std::max(1, best.count()) ? kSecondLine : 1.0;
        if (meets ? !met || price * tried.met.jump < best.met.jump
                  : !met && tried.met.residual < 0.9 * best.met.residual) {
            best = tried;
        }
    }
    return best;
}

double cost_of(const std::vector<TwistedCorner>& corners, double turn) {
    const Eigen::Matrix2d rotation = Eigen::Rotation2Dd(turn).toRotationMatrix();
    std::array<std::vector<double>, 2> at;
    double sum = 0.0;
    for (const TwistedCorner& corner : corners) {
        const Chosen chosen = choose_lines(corner, turn);
        const Eigen::Vector2d uv = rotation * corner.uv;
        if (chosen.count() == 0) {
            sum += kUnmet * corner.twist.squaredNorm();
            continue;
        }
        sum +=
            chosen.met.jump * chosen.met.jump + kUnmet * chosen.met.residual * chosen.met.residual;
        for (std::size_t axis = 0; axis < 2; ++axis) {
            if (chosen.axes[axis]) {
                at[axis].push_back(uv[static_cast<Eigen::Index>(axis)]);
            }
        }
    }
    int lines = 0;
    double sliver = 0.0;
    for (std::vector<double>& positions : at) {
        std::sort(positions.begin(), positions.end());
        for (std::size_t k = 0; k < positions.size(); ++k) {
            const double distance = k > 0 ? positions[k] - positions[k - 1] : kSliver;
            if (distance > kSameLine) {
                ++lines;
                sliver = std::max(sliver, 1.0 - distance / kSliver);
            }
        }
    }
    return std::sqrt(sum) * (1.0 + kLineCost * lines + sliver);
}

double best_turn(const std::vector<TwistedCorner>& corners) {
    double best = 0.0;
    double least = std::numeric_limits<double>::infinity();
    for (int k = 0; k < kTurns; ++k) {
        const double turn = kPi * k / kTurns;
        const double cost = cost_of(corners, turn);
        if (cost < least * (1.0 - 1e-9)) {
            least = cost;
            best = turn;
        }
    }
    return best;
}

Layout turned(const Layout& layout, double turn) {
    const Eigen::Matrix2d rotation = Eigen::Rotation2Dd(turn).toRotationMatrix();
    Eigen::AlignedBox2d box;
    for (const DomainCurve& curve : layout.curves) {
        for (int k = 0; k <= kBoxPoints; ++k) {
            box.extend(rotation * curve.at(static_cast<double>(k) / kBoxPoints));
        }
    }
    Layout result = layout;
    for (DomainCurve& curve : result.curves) {
        curve = curve.moved(rotation, -box.center());
    }
    result.lower = box.min() - box.center();
    result.upper = box.max() - box.center();
    return result;
}

}  // namespace

double KnotLine::weight(double t) const {
    double weight = 1.0;
    for (const Origin& origin : origins) {
        const double x = std::abs(t - origin.along) / origin.reach;
        if (x < 1.0) {
            weight = std::min(weight, x * x * x * (10.0 - 15.0 * x + 6.0 * x * x));
        }
    }
    return weight;
}

LinedLayout with_knot_lines(const RibbonLoop& loop, const Layout& layout, const Scale& scale,
                            double least_twist) {
    LinedLayout result{layout, {}, 0.0};
    const auto corners_in = [&](const Layout& in) {
        return twisted_corners(loop, in, scale, least_twist);
    };
    const std::vector<TwistedCorner> given = corners_in(layout);
    if (given.empty()) {
        return result;
    }
    for (const TwistedCorner& corner : given) {
        result.twist = std::max(result.twist, meet(corner, {}).residual);
    }
    result.layout = turned(layout, best_turn(given));
    if (const Eigen::Vector2d size = result.layout.upper - result.layout.lower;
        size.y() < size.x()) {
        // The solver's matrix has its least bandwidth when the box is longer in v.
        result.layout = turned(result.layout, 0.5 * kPi);
    }
    for (const TwistedCorner& corner : corners_in(result.layout)) {
        const Chosen chosen = choose_lines(corner, 0.0);
        for (int axis = 0; axis < 2; ++axis) {
            if (!chosen.axes[static_cast<std::size_t>(axis)]) {
                continue;
            }
            const double at = corner.uv[axis];
            auto line =
                std::find_if(result.lines.begin(), result.lines.end(), [&](const KnotLine& l) {
                    return l.axis == axis && std::abs(l.at - at) < kSameLine;
                });
            if (line == result.lines.end()) {
                line = result.lines.insert(line, KnotLine{axis, at, {}});
            }
            line->origins.push_back({corner.uv[1 - axis], kReach * corner.shorter_side});
        }
    }
    return result;
}

Axis lined_axis(double lower, double upper, double width, int axis,
                const std::vector<KnotLine>& lines) {
    std::vector<double> ends;
    for (const KnotLine& line : lines) {
        if (line.axis == axis) {
            ends.push_back(line.at);
        }
    }
    std::sort(ends.begin(), ends.end());
    ends.push_back(upper);
    Axis result;
    result.knots.assign(kOrder, lower);
    double from = lower;
    for (std::size_t k = 0; k < ends.size(); ++k) {
        const int spans = std::max(1, static_cast<int>(std::lround((ends[k] - from) / width)));
        for (int i = 1; i < spans; ++i) {
            result.knots.push_back(from + (ends[k] - from) * i / spans);
        }
        result.knots.insert(result.knots.end(), k + 1 < ends.size() ? kMultiplicity : kOrder,
                            ends[k]);
        from = ends[k];
    }
    return result;
}

JumpRow jump_row(const Axis& axis, double at) {
    const auto first = std::lower_bound(axis.knots.begin(), axis.knots.end(), at);
    SUTURE_EXPECTS(first != axis.knots.end() && *first == at);
    const auto left = static_cast<int>(first - axis.knots.begin()) - 1;
    const int right = left + kMultiplicity;
    const auto knot = [&](int k) { return axis.knots[static_cast<std::size_t>(k)]; };
    const double shorter = std::min(at - knot(left), knot(right + 1) - at);
    const Eigen::MatrixXd below = basis_derivatives(axis.knots, kDegree, left, at, 3);
    const Eigen::MatrixXd above = basis_derivatives(axis.knots, kDegree, right, at, 3);
    Eigen::Matrix<double, 2, kOrder + kMultiplicity> jumps;
    jumps.setZero();
    for (int k = 0; k < 2; ++k) {
        const double factor = k == 0 ? 1.0 : shorter;
        jumps.row(k).head<kOrder>() -= factor * below.row(2 + k);
        jumps.row(k).tail<kOrder>() += factor * above.row(2 + k);
    }
    // Only functions whose own knots hold the line three times or four jump there.
    constexpr int kSmooth = kMultiplicity / 2;
    return {left - kDegree + kSmooth, jumps.middleCols<kOrder>(kSmooth)};
}

}  // namespace suture::mvs

#include "suture/fill/mvs/knot_lines.h"

#include "suture/base/contract.h"
#include "suture/base/tolerance.h"
#include "suture/fill/mvs/corner_lines.h"
#include "suture/fill/mvs/shared_lines.h"
#include "suture/spline/knots.h"

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace suture::mvs {
namespace {

// Knots in a line: continuity C1 at degree 5.
constexpr int kMultiplicity = kDegree - 1;
// How the lines run: how finely the turn is sought, and how far from a right angle they may cross.
constexpr int kTurns = 30;
constexpr std::array<double, 7> kShears = {0.0, 15.0, -15.0, 30.0, -30.0, 45.0, -45.0};  // degrees
// What is left of a disagreement counts against the jumps, a line against none; lines nearer than
// this make slivers.
constexpr double kUnmet = 1e4;
constexpr double kLineCost = 0.1;
constexpr double kSliver = 0.04;
// Over so many of the shorter side at a corner the jump dies out, but not over more than this, in
// the solver's unit.
constexpr double kReach = 3.0;
constexpr double kMostReach = 0.5;
// Points a side for the moved layout's box.
constexpr int kBoxPoints = 48;

// The map of the domain that makes the lines those of the net, area for area.
Eigen::Matrix2d map_of(const LineDirections& directions) {
    Eigen::Matrix2d lines;
    lines << std::cos(directions.along_u), std::cos(directions.along_v),
        std::sin(directions.along_u), std::sin(directions.along_v);
    return std::sqrt(lines.determinant()) * lines.inverse();
}

// What the lines cost when they run in these directions.
double cost_of(const std::vector<TwistedCorner>& corners, const Layout& layout, const Scale& scale,
               const LineDirections& directions) {
    const Eigen::Matrix2d map = map_of(directions);
    std::array<std::vector<double>, 2> at;
    double sum = 0.0;
    for (const TwistedCorner& corner : corners) {
        const CornerLines chosen = choose_lines(corner, directions);
        if (chosen.count() == 0) {
            sum += kUnmet * corner.disagreement * corner.disagreement;
            continue;
        }
        sum += chosen.jump * chosen.jump + kUnmet * chosen.residual * chosen.residual;
        const Eigen::Vector2d uv = map * layout.curves[corner.index].at(0.0) / scale.length;
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
    const double crossing = std::sin(directions.along_v - directions.along_u);
    return std::sqrt(sum) * (1.0 + kLineCost * lines + sliver) / crossing;
}

LineDirections best_directions(const std::vector<TwistedCorner>& corners, const Layout& layout,
                               const Scale& scale) {
    LineDirections best;
    double least = std::numeric_limits<double>::infinity();
    for (const double shear : kShears) {
        for (int k = 0; k < kTurns; ++k) {
            const double along_u = -kPi * k / kTurns;
            const LineDirections tried{along_u, along_u + 0.5 * kPi + radians(shear)};
            const double cost = cost_of(corners, layout, scale, tried);
            if (cost < least * (1.0 - 1e-9)) {
                least = cost;
                best = tried;
            }
        }
    }
    return best;
}

// The layout under a linear map, its box about the origin.
Layout mapped(const Layout& layout, const Eigen::Matrix2d& map) {
    Eigen::AlignedBox2d box;
    for (const DomainCurve& curve : layout.curves) {
        for (int k = 0; k <= kBoxPoints; ++k) {
            box.extend(map * curve.at(static_cast<double>(k) / kBoxPoints));
        }
    }
    Layout result = layout;
    for (DomainCurve& curve : result.curves) {
        curve = curve.moved(map, -box.center());
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
    const std::vector<TwistedCorner> corners = twisted_corners(loop, layout, scale, least_twist);
    if (corners.empty()) {
        return result;
    }
    const LineDirections directions = best_directions(corners, layout, scale);
    result.layout = mapped(layout, map_of(directions));
    // The solver's matrix has its least bandwidth when the box is longer in v.
    const Eigen::Vector2d size = result.layout.upper - result.layout.lower;
    const bool turned = size.y() < size.x();
    if (turned) {
        result.layout = mapped(result.layout, Eigen::Rotation2Dd(0.5 * kPi).toRotationMatrix());
    }
    std::array<std::vector<std::size_t>, 2> through;  // corners, for each axis
    for (const TwistedCorner& corner : corners) {
        result.twist = std::max(result.twist, corner.disagreement);
        const CornerLines chosen = choose_lines(corner, directions);
        for (std::size_t axis = 0; axis < 2; ++axis) {
            if (chosen.axes[axis]) {
                through[turned ? 1 - axis : axis].push_back(corner.index);
            }
        }
    }
    const std::array groups = share_lines(through, scale, result.layout);
    for (std::size_t axis = 0; axis < 2; ++axis) {
        for (const std::vector<std::size_t>& group : groups[axis]) {
            const auto a = static_cast<Eigen::Index>(axis);
            KnotLine line;
            line.axis = static_cast<int>(axis);
            for (const std::size_t i : group) {
                const Eigen::Vector2d uv = result.layout.curves[i].at(0.0) / scale.length;
                const auto corner = std::ranges::find(corners, i, &TwistedCorner::index);
                line.at += uv[a] / static_cast<double>(group.size());
                line.origins.push_back(
                    {uv[1 - a], std::min(kReach * corner->shorter_side, kMostReach)});
            }
            result.lines.push_back(std::move(line));
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

#include "suture/fill/tube/border.h"

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace suture::tube {
namespace {

using Eigen::Vector3d;

bool joins_smoothly(const Ribbon& ribbon) {
    return ribbon.continuity >= Continuity::G1;
}

double angle_between(const Vector3d& a, const Vector3d& b) {
    return std::atan2(a.cross(b).norm(), a.dot(b));
}

}  // namespace

Border::Border(RibbonLoop around, Radials radials, const Vector3d& pole, double length, double u)
    : loop_(std::move(around)), radials_(std::move(radials)), pole_(pole), u_(u), starts_{0.0} {
    const RibbonLoop& loop = loop_;
    double total = 0.0;
    for (const Ribbon& ribbon : loop.ribbons) {
        courses_.emplace_back(ribbon);
        total += courses_.back().length();
    }
    for (const Course& course : courses_) {
        starts_.push_back(starts_.back() + length * course.length() / total);
    }
    starts_.back() = length;
    const auto n = loop.ribbons.size();
    bends_.assign(n, {Vector3d::Zero(), Vector3d::Zero()});
    for (std::size_t i = 0; i < n; ++i) {
        if (joins_smoothly(loop.ribbons[i])) {
            continue;
        }
        const auto bend = [&](std::size_t next, double s) -> Vector3d {
            if (!joins_smoothly(loop.ribbons[next])) {
                return Vector3d::Zero();
            }
            const RibbonPoint there = loop.ribbons[next].at(s);
            return radials_.outward(static_cast<int>(next), s, there).normalized() -
                   (there.point - pole).normalized();
        };
        bends_[i] = {bend((i + n - 1) % n, 1.0), bend((i + 1) % n, 0.0)};
    }
}

double Border::s_of(int side, double v) const {
    return course(side).s_of(course(side).length() * v / extent(side));
}

double Border::v_of(int side, double s) const {
    return extent(side) * course(side).length_of(s) / course(side).length();
}

Vector3d Border::outward(int side, double s, const RibbonPoint& at) const {
    const Vector3d radial = radials_.outward(side, s, at);
    if (joins_smoothly(ribbon(side))) {
        return radial / u_;
    }
    const auto& [first, last] = bends_[static_cast<std::size_t>(side)];
    const Vector3d away = (at.point - pole_).normalized();
    return (away + (1.0 - s) * first + s * last).normalized() * (radial.norm() / u_);
}

BorderPoint Border::at(int side, double v) const {
    const double s = s_of(side, v);
    const RibbonPoint at = ribbon(side).at(s);
    const double speed = course(side).length() / extent(side);
    // Sides that keep their own parameter are run through at |dP/ds|, the others evenly.
    const double own = course(side).even() ? at.tangent.norm() / extent(side) : speed;
    return {at.point, outward(side, s, at), at.normal, own * at.tangent.normalized(),
            has_layout() ? radials_.in_plane(side, s) : Eigen::Vector2d(0.0, 0.0)};
}

BorderPoint Border::corner(int side) const {
    const int before = (side + sides() - 1) % sides();
    BorderPoint a = at(before, extent(before));
    const BorderPoint b = at(side, 0.0);
    // Where only one of the two is to be met tangentially, it alone counts.
    const bool smooth_a = joins_smoothly(ribbon(before));
    const bool smooth_b = joins_smoothly(ribbon(side));
    const double share = smooth_a == smooth_b ? 0.5 : smooth_a ? 1.0 : 0.0;
    a.point = 0.5 * (a.point + b.point);
    a.outward = share * a.outward + (1.0 - share) * b.outward;
    a.normal = (share * a.normal + (1.0 - share) * b.normal).normalized();
    a.tangent = 0.5 * (a.tangent + b.tangent);
    a.plane = 0.5 * (a.plane + b.plane);
    return a;
}

double Border::turn(int side) const {
    const int before = (side + sides() - 1) % sides();
    return angle_between(ribbon(before).at(1.0).tangent, ribbon(side).at(0.0).tangent);
}

namespace {

/// Columns of one side by interpolation in the middle of each interval, between given ends.
void fit_side(const Border& border, int side, const std::vector<double>& intervals, int first,
              BorderRows& rows) {
    const int n = static_cast<int>(intervals.size());
    Eigen::MatrixXd system = Eigen::MatrixXd::Zero(n, n);
    Eigen::MatrixXd right(n, 8);
    double v = 0.0;
    for (int k = 0; k < n; ++k) {
        const double g = intervals[static_cast<std::size_t>(k)];
        const int interval = first + k;
        const Ring::Local local = rows.ring.on(interval, rows.ring.start(interval) + 0.5 * g, 0);
        const BorderPoint at = border.at(side, v + 0.5 * g);
        right.row(k) << at.point.transpose(), at.outward.transpose(), at.plane.transpose();
        for (int j = 0; j < 3; ++j) {
            const int column = k + j;  // of the side: 0 and n + 1 are its corners
            const double share = local.basis(0, j);
            if (column >= 1 && column <= n) {
                system(k, column - 1) = share;
            } else {
                const int ring = rows.ring.wrapped(first + column);
                right.row(k).head<3>() -= share * rows.points.col(ring).transpose();
                right.row(k).segment<3>(3) -= share * rows.outward.col(ring).transpose();
                right.row(k).tail<2>() -= share * rows.plane.col(ring).transpose();
            }
        }
        v += g;
    }
    const Eigen::MatrixXd solution = system.partialPivLu().solve(right);
    rows.points.middleCols(first + 1, n) = solution.leftCols<3>().transpose();
    rows.outward.middleCols(first + 1, n) = solution.middleCols<3>(3).transpose();
    rows.plane.middleCols(first + 1, n) = solution.rightCols<2>().transpose();
}

}  // namespace

BorderRows fit_border(const Border& border, const Divisions& divisions) {
    std::vector<double> intervals;
    for (const std::vector<double>& side : divisions) {
        intervals.insert(intervals.end(), side.begin(), side.end());
        intervals.push_back(0.0);
    }
    BorderRows rows{Ring(std::move(intervals)), {}, {}, {}};
    rows.points.resize(3, rows.ring.columns());
    rows.outward.resize(3, rows.ring.columns());
    rows.plane.resize(2, rows.ring.columns());
    int column = 0;
    std::vector<int> firsts;
    for (int side = 0; side < border.sides(); ++side) {
        const BorderPoint corner = border.corner(side);
        rows.points.col(column) = corner.point;
        rows.outward.col(column) = corner.outward;
        rows.plane.col(column) = corner.plane;
        firsts.push_back(column);
        column += static_cast<int>(divisions[static_cast<std::size_t>(side)].size()) + 1;
    }
    for (int side = 0; side < border.sides(); ++side) {
        fit_side(border, side, divisions[static_cast<std::size_t>(side)],
                 firsts[static_cast<std::size_t>(side)], rows);
    }
    if (!border.has_layout()) {
        rows.plane.resize(2, 0);
    }
    return rows;
}

std::vector<std::vector<BorderError>> measure_border(const Border& border,
                                                     const Divisions& divisions,
                                                     const BorderRows& rows) {
    // Between the places that are met, and near the knots.
    constexpr double kPlaces[] = {0.02, 0.15, 0.3, 0.7, 0.85, 0.98};
    std::vector<std::vector<BorderError>> errors;
    int interval = 0;
    for (int side = 0; side < border.sides(); ++side) {
        const auto& own = divisions[static_cast<std::size_t>(side)];
        auto& result = errors.emplace_back(own.size());
        double v = 0.0;
        for (std::size_t k = 0; k < own.size(); ++k, ++interval) {
            for (const double place : kPlaces) {
                const BorderPoint wanted = border.at(side, v + place * own[k]);
                const Ring::Local local =
                    rows.ring.on(interval, rows.ring.start(interval) + place * own[k], 1);
                Vector3d point = Vector3d::Zero();
                Vector3d tangent = Vector3d::Zero();
                Vector3d outward = Vector3d::Zero();
                for (int j = 0; j < 3; ++j) {
                    const int column = rows.ring.wrapped(local.first + j);
                    point += local.basis(0, j) * rows.points.col(column);
                    tangent += local.basis(1, j) * rows.points.col(column);
                    outward += local.basis(0, j) * rows.outward.col(column);
                }
                BorderError& error = result[k];
                error.gap = std::max(error.gap, (point - wanted.point).norm());
                if (joins_smoothly(border.ribbon(side))) {
                    error.angle =
                        std::max(error.angle, angle_between(outward.cross(tangent), wanted.normal));
                }
            }
            v += own[k];
        }
        ++interval;  // the corner's empty one
    }
    return errors;
}

namespace {

/// A share of the tolerance: what is left is for the edges of the model and for the file.
constexpr double kShare = 0.3;
constexpr int kMostColumns = 600;
constexpr int kMostOnSide = 150;
constexpr int kFirstOnSide = 4;
constexpr int kMostRounds = 12;
/// Below this turn of the border a corner is none, and needs no short intervals.
constexpr double kSharp = radians(2.0);

/// An interval cut into pieces of which each is twice as long as the one before, from its
/// beginning, the first no longer than `first`.
std::vector<double> graded(double interval, double first) {
    std::vector<double> pieces;
    while (interval > first) {
        interval *= 0.5;
        pieces.push_back(interval);
    }
    pieces.push_back(interval);
    std::reverse(pieces.begin(), pieces.end());
    return pieces;
}

void grade(const Border& border, double first, Divisions& divisions) {
    for (int side = 0; side < border.sides(); ++side) {
        auto& own = divisions[static_cast<std::size_t>(side)];
        if (border.turn(side) > kSharp) {
            const auto pieces = graded(own.front(), first);
            own.erase(own.begin());
            own.insert(own.begin(), pieces.begin(), pieces.end());
        }
        if (border.turn((side + 1) % border.sides()) > kSharp) {
            const auto pieces = graded(own.back(), first);
            own.pop_back();
            own.insert(own.end(), pieces.rbegin(), pieces.rend());
        }
    }
}

}  // namespace

Divisions divide(const Border& border, const Tolerance& tolerance, double first) {
    Divisions divisions;
    for (int side = 0; side < border.sides(); ++side) {
        divisions.emplace_back(kFirstOnSide, border.extent(side) / kFirstOnSide);
    }
    grade(border, first, divisions);
    for (int round = 0; round < kMostRounds; ++round) {
        const auto errors = measure_border(border, divisions, fit_border(border, divisions));
        std::size_t columns = 0;
        bool done = true;
        Divisions next(divisions.size());
        for (std::size_t side = 0; side < divisions.size(); ++side) {
            for (std::size_t k = 0; k < divisions[side].size(); ++k) {
                const BorderError& error = errors[side][k];
                const double g = divisions[side][k];
                if (error.gap > kShare * tolerance.linear ||
                    error.angle > kShare * tolerance.angular) {
                    next[side].insert(next[side].end(), 2, 0.5 * g);
                    done = false;
                } else {
                    next[side].push_back(g);
                }
            }
            if (next[side].size() > static_cast<std::size_t>(kMostOnSide)) {
                next[side] = divisions[side];
            }
            columns += next[side].size() + 1;
        }
        if (done || columns > static_cast<std::size_t>(kMostColumns) || next == divisions) {
            break;
        }
        divisions = std::move(next);
    }
    return divisions;
}

}  // namespace suture::tube

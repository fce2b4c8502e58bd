#include "suture/fill/tube/border.h"

#include "suture/base/contract.h"

#include <Eigen/Geometry>
#include <Eigen/SparseLU>

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
    shifts_.resize(n);
    for (int side = 0; side < sides(); ++side) {
        bring_together(side);
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
    const double by_v = course(side).length() / (extent(side) * course(side).speed_of(s));  // ds/dv
    BorderPoint result{at.point,
                       at.point,
                       outward(side, s, at),
                       at.normal,
                       by_v * at.tangent,
                       has_layout() ? radials_.in_plane(side, s) : Eigen::Vector2d(0.0, 0.0)};
    const double t = v / extent(side);
    const double late = t * t * (3.0 - 2.0 * t);
    const double slope = 6.0 * t * (1.0 - t) / extent(side);
    const auto& [first, last] = shifts_[static_cast<std::size_t>(side)];
    result.point += (1.0 - late) * first.point + late * last.point;
    result.tangent += slope * (last.point - first.point);
    result.outward += (1.0 - late) * first.outward + late * last.outward;
    result.plane += (1.0 - late) * first.plane + late * last.plane;
    return result;
}

void Border::bring_together(int side) {
    const int before = (side + sides() - 1) % sides();
    const BorderPoint a = at(before, extent(before));
    const BorderPoint b = at(side, 0.0);
    // The outward tangent should be in both tangent planes. What it is off by turns the normal the
    // more, the less it leads away from the border; so that side counts more. Where only one of the
    // two is to be met tangentially, it alone counts.
    const auto leads_away = [](const BorderPoint& at) {
        return at.outward.normalized().cross(at.tangent.normalized()).norm();
    };
    double share = leads_away(b) / (leads_away(a) + leads_away(b));
    if (joins_smoothly(ribbon(before)) != joins_smoothly(ribbon(side))) {
        share = joins_smoothly(ribbon(before)) ? 1.0 : 0.0;
    }
    const Vector3d point = 0.5 * (a.point + b.point);
    const Vector3d outward = share * a.outward + (1.0 - share) * b.outward;
    const Eigen::Vector2d plane = 0.5 * (a.plane + b.plane);
    shifts_[static_cast<std::size_t>(before)][1] = {point - a.point, outward - a.outward,
                                                    plane - a.plane};
    shifts_[static_cast<std::size_t>(side)][0] = {point - b.point, outward - b.outward,
                                                  plane - b.plane};
}

double Border::turn(int side) const {
    const int before = (side + sides() - 1) % sides();
    return angle_between(ribbon(before).at(1.0).tangent, ribbon(side).at(0.0).tangent);
}

bool Border::is_sharp(int side, const Tolerance& tolerance) const {
    const int before = (side + sides() - 1) % sides();
    const Vector3d a = at(before, extent(before)).tangent;
    const Vector3d b = at(side, 0.0).tangent;
    // What is below that is not seen by any measure of the border.
    constexpr double kUnseen = 0.1;
    return (a - b).norm() > kUnseen * tolerance.angular * std::min(a.norm(), b.norm());
}

namespace {

/// A row for each column: what it is to be at its place of the border, and which columns it is the
/// sum of.
struct Interpolation {
    std::vector<Eigen::Triplet<double>> shares;
    Eigen::MatrixXd wanted;

    void ask(int row, const BorderPoint& at) {
        wanted.row(row) << at.point.transpose(), at.outward.transpose(), at.plane.transpose();
    }
};

}  // namespace

BorderRows fit_border(const Border& border, const Divisions& divisions,
                      const Tolerance& tolerance) {
    std::vector<double> intervals;
    std::vector<bool> sharp;
    for (int side = 0; side < border.sides(); ++side) {
        const auto& own = divisions[static_cast<std::size_t>(side)];
        intervals.insert(intervals.end(), own.begin(), own.end());
        sharp.push_back(border.is_sharp((side + 1) % border.sides(), tolerance));
        if (sharp.back()) {
            intervals.push_back(0.0);
        }
    }
    BorderRows rows{Ring(std::move(intervals)), {}, {}, {}};
    const int m = rows.ring.columns();
    Interpolation task{{}, Eigen::MatrixXd(m, 8)};
    int interval = 0;
    for (int side = 0; side < border.sides(); ++side) {
        double v = 0.0;
        for (const double g : divisions[static_cast<std::size_t>(side)]) {
            const Ring::Local local =
                rows.ring.on(interval, rows.ring.start(interval) + 0.5 * g, 0);
            task.ask(interval, border.at(side, v + 0.5 * g));
            for (int j = 0; j < 3; ++j) {
                task.shares.emplace_back(interval, rows.ring.wrapped(interval + j),
                                         local.basis(0, j));
            }
            v += g;
            ++interval;
        }
        if (sharp[static_cast<std::size_t>(side)]) {
            task.ask(interval, border.corner((side + 1) % border.sides()));
            task.shares.emplace_back(interval, rows.ring.wrapped(interval + 1), 1.0);
            ++interval;
        }
    }
    Eigen::SparseMatrix<double> system(m, m);
    system.setFromTriplets(task.shares.begin(), task.shares.end());
    const Eigen::SparseLU<Eigen::SparseMatrix<double>> factor(system);
    SUTURE_EXPECTS(factor.info() == Eigen::Success);
    const Eigen::MatrixXd solution = factor.solve(task.wanted);
    rows.points = solution.leftCols<3>().transpose();
    rows.outward = solution.middleCols<3>(3).transpose();
    if (border.has_layout()) {
        rows.plane = solution.rightCols<2>().transpose();
    } else {
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
                const Vector3d normal = outward.cross(tangent);
                error.gap = std::max(error.gap, (point - wanted.edge).norm());
                error.fit_gap = std::max(error.fit_gap, (point - wanted.point).norm());
                if (joins_smoothly(border.ribbon(side))) {
                    error.angle = std::max(error.angle, angle_between(normal, wanted.normal));
                    error.fit_angle =
                        std::max(error.fit_angle,
                                 angle_between(normal, wanted.outward.cross(wanted.tangent)));
                }
            }
            v += own[k];
        }
        if (rows.ring.interval(interval) == 0.0) {
            ++interval;  // the corner's
        }
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
        const auto errors =
            measure_border(border, divisions, fit_border(border, divisions, tolerance));
        std::size_t columns = 0;
        bool done = true;
        Divisions next(divisions.size());
        for (std::size_t side = 0; side < divisions.size(); ++side) {
            for (std::size_t k = 0; k < divisions[side].size(); ++k) {
                const BorderError& error = errors[side][k];
                const double g = divisions[side][k];
                if (error.fit_gap > kShare * tolerance.linear ||
                    error.fit_angle > kShare * tolerance.angular) {
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

#include "suture/fill/tube/divide.h"

#include "suture/fill/tube/directions.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace suture::tube {

using Eigen::Vector3d;

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
/// A side may have its share of the columns, and no fewer than this.
constexpr int kLeastShare = 150;
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

/// How long intervals may be beside a reflex corner, as a share of a layer's width: rows inside go
/// smoothly through it, on the border's side of their corner, and must not get there.
double share_beside(const Border& border, int side) {
    constexpr double kLeast = 1.0 / 64.0;
    const int before = (side + border.sides() - 1) % border.sides();
    const BorderPoint a = border.at(before, border.extent(before));
    const BorderPoint b = border.corner(side);
    if ((b.tangent.normalized() - a.tangent.normalized()).dot(b.outward) <= 0.0) {
        return 1.0;  // convex
    }
    const auto across = [](const BorderPoint& p) {
        return p.outward.cross(p.tangent).norm() / p.tangent.squaredNorm();
    };
    return std::clamp(std::min(across(a), across(b)), kLeast, 1.0);
}

void grade(const Border& border, double layer, Divisions& divisions) {
    for (int side = 0; side < border.sides(); ++side) {
        const int next = (side + 1) % border.sides();
        auto& own = divisions[static_cast<std::size_t>(side)];
        if (border.turn(side) > kSharp) {
            const auto pieces = graded(own.front(), layer * share_beside(border, side));
            own.erase(own.begin());
            own.insert(own.begin(), pieces.begin(), pieces.end());
        }
        if (border.turn(next) > kSharp) {
            const auto pieces = graded(own.back(), layer * share_beside(border, next));
            own.pop_back();
            own.insert(own.end(), pieces.rbegin(), pieces.rend());
        }
    }
}

}  // namespace

Divisions divide(const Border& border, const Tolerance& tolerance, double first, const Way& way) {
    Divisions divisions;
    for (int side = 0; side < border.sides(); ++side) {
        divisions.emplace_back(kFirstOnSide, border.extent(side) / kFirstOnSide);
    }
    grade(border, first, divisions);
    const auto most_on_side =
        static_cast<std::size_t>(std::max(kLeastShare, kMostColumns / border.sides()));
    for (int round = 0; round < kMostRounds; ++round) {
        const auto errors =
            measure_border(border, divisions, fit_border(border, divisions, tolerance, way));
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
            if (next[side].size() > most_on_side) {
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

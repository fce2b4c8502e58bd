#include "suture/fill/tube/border_fit.h"

#include "suture/base/contract.h"
#include "suture/fill/tube/stripe.h"

#include <Eigen/SparseLU>

#include <algorithm>
#include <cmath>

namespace suture::tube {
namespace {

using Eigen::Vector3d;

using Intervals = std::vector<double>;

/// What a column holds: point, c of (8); outward tangent, d of (9); place in the plane. Theorem 1
/// takes them at the corners alone, by (2), (3), (4), (5), (6) and (7).
constexpr int kValues = 8;
using Values = Eigen::Matrix<double, kValues, 1>;

Values values_of(const BorderPoint& at) {
    Values values;
    values << at.point, at.outward, at.plane;
    return values;
}

/// The ring's intervals: those of each side, and an empty one before a sharp corner.
Intervals intervals_of(const Divisions& divisions, const std::vector<bool>& sharp) {
    Intervals intervals;
    for (std::size_t side = 0; side < divisions.size(); ++side) {
        intervals.insert(intervals.end(), divisions[side].begin(), divisions[side].end());
        if (sharp[(side + 1) % sharp.size()]) {
            intervals.push_back(0.0);
        }
    }
    return intervals;
}

/// Columns that interpolate in the middle of each interval, and at sharp corners.
Eigen::MatrixXd interpolate(const Border& border, const Divisions& divisions,
                            const std::vector<bool>& sharp, const Ring& ring) {
    const int m = ring.columns();
    std::vector<Eigen::Triplet<double>> shares;
    Eigen::MatrixXd wanted(m, kValues);
    int interval = 0;
    for (int side = 0; side < border.sides(); ++side) {
        double v = 0.0;
        for (const double g : divisions[static_cast<std::size_t>(side)]) {
            const Ring::Local local = ring.on(interval, ring.start(interval) + 0.5 * g, 0);
            wanted.row(interval) = values_of(border.at(side, v + 0.5 * g)).transpose();
            for (int j = 0; j < 3; ++j) {
                shares.emplace_back(interval, ring.wrapped(interval + j), local.basis(0, j));
            }
            v += g;
            ++interval;
        }
        const int next = (side + 1) % border.sides();
        if (sharp[static_cast<std::size_t>(next)]) {
            wanted.row(interval) = values_of(border.corner(next)).transpose();
            shares.emplace_back(interval, ring.wrapped(interval + 1), 1.0);
            ++interval;
        }
    }
    Eigen::SparseMatrix<double> system(m, m);
    system.setFromTriplets(shares.begin(), shares.end());
    const Eigen::SparseLU<Eigen::SparseMatrix<double>> factor(system);
    SUTURE_EXPECTS(factor.info() == Eigen::Success);
    return factor.solve(wanted).transpose();
}

/// Sides that go on smoothly, from one sharp corner to the next or all the way around.
struct Run {
    std::vector<int> sides;
    int column = 0;  ///< the first
    bool closed = false;
};

std::vector<Run> runs_of(const Divisions& divisions, const std::vector<bool>& sharp) {
    const int n = static_cast<int>(sharp.size());
    const auto corner = std::find(sharp.begin(), sharp.end(), true);
    if (corner == sharp.end()) {
        Run run{{}, 0, true};
        for (int side = 0; side < n; ++side) {
            run.sides.push_back(side);
        }
        return {run};
    }
    // The column at which each side begins: at a sharp corner the double one.
    std::vector<int> columns;
    int column = 0;
    for (int side = 0; side < n; ++side) {
        columns.push_back(column);
        const auto next = static_cast<std::size_t>((side + 1) % n);
        column += static_cast<int>(divisions[static_cast<std::size_t>(side)].size());
        column += sharp[next] ? 1 : 0;
    }
    std::vector<Run> runs;
    const int first = static_cast<int>(corner - sharp.begin());
    for (int k = 0; k < n; ++k) {
        const int side = (first + k) % n;
        if (sharp[static_cast<std::size_t>(side)]) {
            runs.push_back({{}, columns[static_cast<std::size_t>(side)], false});
        }
        runs.back().sides.push_back(side);
    }
    return runs;
}

/// Derivatives from values to the right of a place.
Vector3d first_derivative(const Curve& curve, double t, double step) {
    return (-25.0 * curve(t) + 48.0 * curve(t + step) - 36.0 * curve(t + 2.0 * step) +
            16.0 * curve(t + 3.0 * step) - 3.0 * curve(t + 4.0 * step)) /
           (12.0 * step);
}
Vector3d second_derivative(const Curve& curve, double t, double step) {
    return (35.0 * curve(t) - 104.0 * curve(t + step) + 114.0 * curve(t + 2.0 * step) -
            56.0 * curve(t + 3.0 * step) + 11.0 * curve(t + 4.0 * step)) /
           (12.0 * step * step);
}

std::vector<Piece> pieces_of(const Curve& curve, const std::vector<double>& t, Way::Pieces pieces) {
    if (pieces == Way::Pieces::Bezier) {
        return bezier_pieces(curve, t);
    }
    double shortest = INFINITY;
    for (std::size_t k = 0; k + 1 < t.size(); ++k) {
        shortest = std::min(shortest, t[k + 1] - t[k]);
    }
    constexpr double kStep = 0.05;
    const double step = kStep * shortest;
    return taylor_pieces(
        curve, [&](double at) { return first_derivative(curve, at, step); },
        [&](double at) { return second_derivative(curve, at, step); }, t);
}

/// Columns from quadratic pieces, as the paper has them.
Eigen::MatrixXd join_pieces(const Border& border, const Divisions& divisions,
                            const std::vector<bool>& sharp, int columns, const Way& way) {
    Eigen::MatrixXd result(kValues, columns);
    for (const Run& run : runs_of(divisions, sharp)) {
        Intervals intervals;
        std::vector<double> t = {0.0};
        for (const int side : run.sides) {
            for (const double g : divisions[static_cast<std::size_t>(side)]) {
                intervals.push_back(g);
                t.push_back(t.back() + g);
            }
        }
        const auto at = [&](double v) {
            for (const int side : run.sides) {
                if (v <= border.extent(side) || side == run.sides.back()) {
                    return values_of(border.at(side, std::min(v, border.extent(side))));
                }
                v -= border.extent(side);
            }
            return Values();
        };
        const Ends ends = run.closed ? Ends::Closed : Ends::Clamped;
        // Three coordinates at a time; the last ones are two.
        for (const int row : {0, 3, kValues - 3}) {
            const auto pieces = pieces_of(
                [&](double v) -> Vector3d { return at(v).segment<3>(row); }, t, way.pieces);
            const Eigen::Matrix3Xd own = way.join == Way::Join::Marching
                                             ? march(pieces, intervals, ends)
                                             : fit_all(pieces, intervals, ends);
            for (Eigen::Index j = 0; j < own.cols(); ++j) {
                const auto column = static_cast<Eigen::Index>(run.column + j) % columns;
                result.col(column).segment<3>(row) = own.col(j);
            }
        }
    }
    return result;
}

}  // namespace

BorderRows fit_border(const Border& border, const Divisions& divisions, const Tolerance& tolerance,
                      const Way& way) {
    std::vector<bool> sharp(static_cast<std::size_t>(border.sides()));
    for (int side = 0; side < border.sides(); ++side) {
        sharp[static_cast<std::size_t>(side)] = border.is_sharp(side, tolerance);
    }
    BorderRows rows{Ring(intervals_of(divisions, sharp)), {}, {}, {}};
    const Eigen::MatrixXd columns =
        way.pieces == Way::Pieces::Interpolated
            ? interpolate(border, divisions, sharp, rows.ring)
            : join_pieces(border, divisions, sharp, rows.ring.columns(), way);
    rows.points = columns.topRows<3>();
    rows.outward = columns.middleRows<3>(3);
    rows.plane = columns.bottomRows<2>();
    if (!border.has_layout()) {
        rows.plane.resize(2, 0);
    }
    return rows;
}

}  // namespace suture::tube

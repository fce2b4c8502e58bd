#include "suture/fill/concentric/lift.h"

#include "suture/fill/concentric/sweep.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace suture::concentric {
namespace {

using Eigen::Map;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

/// What surfaces may miss, as shares of the tolerance: normals along the hole's own edges, along
/// seams and the axis, where both sides differ, and inside of faces, where a shape is what it is.
constexpr double kBorderShare = 0.3;
constexpr double kSeamShare = 0.2;
constexpr double kAxisShare = 0.03;
constexpr double kInnerShare = 10.0;

/// Positions along the axis, where faces meet, and inside: as shares of the tolerance.
constexpr double kAxisPlace = 1e-3;
constexpr double kInnerPlace = 1.0;

/// Spokes take a share of what is allowed inside.
constexpr double kRadialShare = 0.5;

/// The most spans in t.
constexpr int kMostSpans = 32;

/// Degrees to choose the one from that takes fewest poles.
constexpr int kDegrees[] = {3, 4, 5};

/// Shorter spans of a strip, as a share of it, are none.
constexpr double kLeastSpan = 0.01;

/// Spokes of a strip to choose the knots in t by, as parts of it.
constexpr double kTrials[] = {0.0, 0.25, 0.5, 0.75, 1.0};

constexpr double kTimes[] = {0.0, 0.04, 0.15, 0.4, 0.7, 0.9, 1.0};

/// A curve and one that begins where it ends, of one degree.
void append(SplineCurve& all, const SplineCurve& next) {
    MatrixXd poles(all.poles.rows(), all.count() + next.count() - 1);
    poles << all.poles, next.poles.rightCols(next.count() - 1);
    all.knots.pop_back();
    all.knots.insert(all.knots.end(), next.knots.begin() + next.degree + 1, next.knots.end());
    all.poles = std::move(poles);
}

double angle_between(const Vector3d& a, const Vector3d& b) {
    return std::atan2(a.cross(b).norm(), a.dot(b));
}

}  // namespace

Lift::Lift(const Hole& hole, const Boundary& boundary, const Guide& guide,
           const ConcentricCurve& axis, const std::vector<Region>& regions,
           const Tolerance& tolerance)
    : tolerance_(tolerance), spokes_(hole, boundary, guide, axis) {
    choose_radial_knots(regions);
}

std::vector<Strip> Lift::strips(const Region& region) {
    std::vector<Strip> all;
    for (const Course& course : region.courses) {
        const int last =
            std::min(static_cast<int>(std::ceil(course.to)), region.first + region.count);
        for (int side = static_cast<int>(std::floor(course.from)); side < last; ++side) {
            const Strip strip{side, course, std::max(course.from, 1.0 * side),
                              std::min(course.to, side + 1.0)};
            if (strip.to - strip.from > kSameParameter) {
                all.push_back(strip);
            }
        }
    }
    return all;
}

Lift::Data Lift::data(const MovingSpoke& spoke) const {
    const int n = radial_.count();
    Data all{MatrixXd(3, n), MatrixXd(3, n)};
    const auto put = [&](int k, const Vector3d& x, const Vector3d& change) {
        all.points.col(k) = x;
        all.changes.col(k) = change;
    };
    const SpokeJet start = spokes_.jet(spoke, 0.0);
    const SpokeJet end = spokes_.jet(spoke, 1.0);
    put(0, start.point, start.s);
    put(1, start.t, start.st);
    for (int k = 2; k < n - 2; ++k) {
        const SpokeJet jet = spokes_.jet(spoke, radial_.sites()[static_cast<std::size_t>(k - 2)]);
        put(k, jet.point, jet.s);
    }
    put(n - 2, end.t, end.st);
    put(n - 1, end.point, end.s);
    return all;
}

/// Against what is allowed.
double Lift::missed_by(const SpokeJet& made, const SpokeJet& wanted, double angle,
                       double place) const {
    return std::max(angle_between(made.s.cross(made.t), wanted.s.cross(wanted.t)) /
                        (angle * tolerance_.angular),
                    (made.point - wanted.point).norm() / (place * tolerance_.linear));
}

/// How far a spoke's spline misses it on each span, against what is allowed.
void Lift::measure_spoke(const MovingSpoke& spoke, double share,
                         std::vector<double>& missed) const {
    const Data all = data(spoke);
    const MatrixXd points = radial_.poles(all.points);
    const MatrixXd changes = radial_.poles(all.changes);
    const std::vector<double>& breaks = radial_.breaks();
    for (std::size_t k = 0; k + 1 < breaks.size(); ++k) {
        for (const double x : {0.1, 0.3, 0.5, 0.7, 0.9}) {
            const double t = breaks[k] + x * (breaks[k + 1] - breaks[k]);
            const MatrixXd p = radial_.evaluate(points, t);
            const MatrixXd d = radial_.evaluate(changes, t);
            const SpokeJet made{p.col(0), d.col(0), p.col(1), d.col(1)};
            missed[k] = std::max(missed[k], missed_by(made, spokes_.jet(spoke, t), share,
                                                      kRadialShare * kInnerPlace));
        }
    }
}

/// As few spans as bring spokes and their normals within what is allowed.
void Lift::choose_radial_knots(const std::vector<Region>& regions) {
    std::vector<double> breaks = {0.0, 1.0};
    for (;;) {
        radial_ = Radial(breaks);
        std::vector<double> missed(breaks.size() - 1, 0.0);
        for (const Region& region : regions) {
            for (const Strip& strip : strips(region)) {
                for (const double part : kTrials) {
                    // Where strips meet, normals of both sides have to be the same.
                    const bool inside = part > 0.0 && part < 1.0;
                    const double s = (1.0 - part) * strip.from + part * strip.to;
                    measure_spoke(spokes_.moving(strip, s),
                                  inside ? kRadialShare * kInnerShare : kSeamShare, missed);
                }
            }
        }
        std::vector<double> finer = breaks;
        for (std::size_t k = 0; k + 1 < breaks.size(); ++k) {
            if (missed[k] > 1.0) {
                finer.push_back(0.5 * (breaks[k] + breaks[k + 1]));
            }
        }
        if (finer.size() == breaks.size() || static_cast<int>(finer.size()) > kMostSpans + 1) {
            return;
        }
        std::sort(finer.begin(), finer.end());
        breaks = std::move(finer);
    }
}

/// Between two breaks of a strip.
double Lift::missed_on(const Strip& strip, const SplineCurve& gamma, const SplineCurve& rows,
                       double from, double to) {
    const int n = radial_.count();
    const bool rests = strip.course.start == strip.course.end;
    double missed = 0.0;
    for (const double part : {0.05, 0.27, 0.5, 0.73, 0.95}) {
        const double s = from + part * (to - from);
        const MovingSpoke spoke = spokes_.moving(strip, s);
        const MatrixXd start = evaluate(gamma, s, 1);
        const MatrixXd others = evaluate(rows, s, 1);
        MatrixXd points(3, n);
        MatrixXd changes(3, n);
        points << start.col(0), Map<const MatrixXd>(others.col(0).data(), 3, n - 1);
        changes << start.col(1), Map<const MatrixXd>(others.col(1).data(), 3, n - 1);
        points = radial_.poles(points);
        changes = radial_.poles(changes);
        for (const double t : kTimes) {
            if (rests && t == 1.0) {
                continue;  // a point
            }
            const MatrixXd p = radial_.evaluate(points, t);
            const MatrixXd d = radial_.evaluate(changes, t);
            const SpokeJet wanted = spokes_.jet(spoke, t);
            const double angle = t == 0.0 ? kBorderShare : t == 1.0 ? kAxisShare : kInnerShare;
            missed = std::max(missed, missed_by({p.col(0), d.col(0), p.col(1), d.col(1)}, wanted,
                                                angle, t == 1.0 ? kAxisPlace : kInnerPlace));
            error_ = std::max(error_, (p.col(0) - wanted.point).norm());
        }
    }
    return missed;
}

/// All but the row along the side, strip by strip: with the slopes at their ends faces meet at
/// seams as their spokes do.
FittedCurve Lift::fit(const Region& region, const SplineCurve& gamma) {
    const auto row = [](const MatrixXd& all) -> VectorXd {
        return Map<const VectorXd>(all.col(1).data(), all.size() - 3);
    };
    FittedCurve all;
    for (const Strip& strip : strips(region)) {
        const auto at = [&](double s) { return row(data(spokes_.moving(strip, s)).points); };
        const EndSlopes slopes{row(data(spokes_.moving(strip, strip.from)).changes),
                               row(data(spokes_.moving(strip, strip.to)).changes)};
        std::vector<Break> breaks = {{strip.from, 0}, {strip.to, 0}};
        // The side's knots, but for those that would only make a sliver of a span.
        const double least = kLeastSpan * (strip.to - strip.from);
        double last = strip.from;
        for (const double knot : gamma.knots) {
            if (knot > last + least && knot < strip.to - least) {
                const auto times = std::count(gamma.knots.begin(), gamma.knots.end(), knot);
                breaks.push_back({knot, std::max(0, gamma.degree - static_cast<int>(times))});
                last = knot;
            }
        }
        const FittedCurve piece = fit_curve(at, slopes, sorted(std::move(breaks)), gamma.degree,
                                            [&](const SplineCurve& rows, double from, double to) {
                                                return missed_on(strip, gamma, rows, from, to);
                                            });
        all.error = std::max(all.error, piece.error);
        if (all.curve.knots.empty()) {
            all.curve = piece.curve;
        } else {
            append(all.curve, piece.curve);
        }
    }
    return all;
}

SplineSurface Lift::surface(const Region& region) {
    SplineCurve gamma;
    FittedCurve fitted;
    for (const int degree : kDegrees) {
        SplineCurve side = elevated(region.side, std::max(degree, region.side.degree));
        FittedCurve fit = this->fit(region, side);
        make_compatible(side, fit.curve);
        const bool better = fit.error <= std::max(1.0, fitted.error) &&
                            (side.count() < gamma.count() || fitted.error > 1.0);
        if (gamma.knots.empty() || better) {
            gamma = std::move(side);
            fitted = std::move(fit);
        }
    }
    missed_ = std::max(missed_, fitted.error);
    std::vector<SplineCurve> rows(static_cast<std::size_t>(radial_.count()), gamma);
    for (int k = 0; k < gamma.count(); ++k) {
        MatrixXd points(3, radial_.count());
        points << gamma.poles.col(k),
            Map<const MatrixXd>(fitted.curve.poles.col(k).data(), 3, radial_.count() - 1);
        const MatrixXd poles = radial_.poles(points);
        for (int j = 0; j < radial_.count(); ++j) {
            rows[static_cast<std::size_t>(j)].poles.col(k) = poles.col(j);
        }
    }
    collapse_rests(rows.back(), region.courses, [&](int node) { return vertex(node); });
    return from_rows(rows, radial_.knots());
}

}  // namespace suture::concentric

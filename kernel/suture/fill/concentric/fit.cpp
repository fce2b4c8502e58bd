#include "suture/fill/concentric/fit.h"

#include "suture/spline/knots.h"

#include <Eigen/Sparse>
#include <Eigen/SparseLU>

#include <algorithm>
#include <cmath>

namespace suture::concentric {
namespace {

using Eigen::MatrixXd;

/// Rounds of halving intervals, and breaks that come of it, at most.
constexpr int kRounds = 10;
constexpr std::size_t kMostNewBreaks = 200;

/// From this round on, an error that does not fall to this share of the last one's is no matter of
/// knots: the function is not smooth.
constexpr int kSettled = 6;
constexpr double kFall = 0.8;

/// Samples of each interval to measure the error at, as parts of it. Off-centre: the error of an
/// interpolant can vanish in the middle by symmetry.
constexpr double kProbes[] = {0.13, 0.47, 0.8};

/// Slopes, if given, in place of the values at the Greville points next to the ends.
SplineCurve interpolated(const std::function<Eigen::VectorXd(double)>& at, const EndSlopes* slopes,
                         const std::vector<Break>& breaks, int degree) {
    const double from = breaks.front().at;
    const double to = breaks.back().at;
    SplineCurve curve{degree, std::vector<double>(static_cast<std::size_t>(degree + 1), from), {}};
    for (std::size_t i = 1; i < breaks.size(); ++i) {
        const int times = i + 1 == breaks.size() ? degree + 1 : degree - breaks[i].smooth;
        curve.knots.insert(curve.knots.end(), static_cast<std::size_t>(times), breaks[i].at);
    }
    const auto n = static_cast<int>(curve.knots.size()) - degree - 1;
    curve.poles.resize(at(from).size(), n);
    const std::vector<double> nodes = greville(curve);
    std::vector<Eigen::Triplet<double>> entries;
    MatrixXd values(n, curve.poles.rows());
    const auto add = [&](int row, double t, int order, const Eigen::VectorXd& value) {
        const int span = find_span(curve.knots, degree, t);
        const MatrixXd basis = basis_derivatives(curve.knots, degree, span, t, order);
        for (int k = 0; k <= degree; ++k) {
            entries.emplace_back(row, span - degree + k, basis(order, k));
        }
        values.row(row) = value.transpose();
    };
    for (int i = 0; i < n; ++i) {
        if (slopes != nullptr && i == 1) {
            add(i, from, 1, slopes->from);
        } else if (slopes != nullptr && i == n - 2) {
            add(i, to, 1, slopes->to);
        } else {
            const double t = nodes[static_cast<std::size_t>(i)];
            add(i, t, 0, at(t));
        }
    }
    Eigen::SparseMatrix<double> matrix(n, n);
    matrix.setFromTriplets(entries.begin(), entries.end());
    const Eigen::SparseLU<Eigen::SparseMatrix<double>> solver(matrix);
    const MatrixXd poles = solver.solve(values);
    curve.poles = poles.transpose();
    curve.poles.col(0) = at(from);
    curve.poles.col(n - 1) = at(to);
    return curve;
}

FittedCurve refined_fit(const std::function<Eigen::VectorXd(double)>& at, const EndSlopes* slopes,
                        std::vector<Break> breaks, int degree, const Missed& missed) {
    FittedCurve best;
    best.error = INFINITY;
    const std::size_t most = breaks.size() + kMostNewBreaks;
    for (int round = 0;; ++round) {
        FittedCurve fit{interpolated(at, slopes, breaks, degree), 0.0};
        std::vector<Break> finer = breaks;
        for (std::size_t i = 1; i < breaks.size(); ++i) {
            const double from = breaks[i - 1].at;
            const double to = breaks[i].at;
            const double error = missed(fit.curve, from, to);
            if (error > 1.0) {
                finer.push_back({0.5 * (from + to), degree - 1});
            }
            fit.error = std::max(fit.error, error);
        }
        const bool settled = round >= kSettled && fit.error > kFall * best.error;
        if (fit.error < best.error) {
            best = std::move(fit);
        }
        if (finer.size() == breaks.size() || finer.size() > most || settled || round == kRounds) {
            return best;
        }
        breaks = sorted(std::move(finer));
    }
}

}  // namespace

std::vector<Break> sorted(std::vector<Break> breaks) {
    std::sort(breaks.begin(), breaks.end(), [](const Break& a, const Break& b) {
        return a.at < b.at || (a.at == b.at && a.smooth < b.smooth);
    });
    breaks.erase(std::unique(breaks.begin(), breaks.end(),
                             [](const Break& a, const Break& b) { return a.at == b.at; }),
                 breaks.end());
    return breaks;
}

SplineCurve interpolated(const std::function<Eigen::VectorXd(double)>& at,
                         const std::vector<Break>& breaks, int degree) {
    return interpolated(at, nullptr, breaks, degree);
}

FittedCurve fit_curve(const std::function<Eigen::VectorXd(double)>& at, std::vector<Break> breaks,
                      int degree, double accuracy) {
    const auto missed = [&](const SplineCurve& curve, double from, double to) {
        double error = 0.0;
        for (const double part : kProbes) {
            const double t = from + part * (to - from);
            error = std::max(error, (evaluate(curve, t).col(0) - at(t)).norm());
        }
        return error / accuracy;
    };
    FittedCurve fit = refined_fit(at, nullptr, std::move(breaks), degree, missed);
    fit.error *= accuracy;
    return fit;
}

FittedCurve fit_curve(const std::function<Eigen::VectorXd(double)>& at, const EndSlopes& slopes,
                      std::vector<Break> breaks, int degree, const Missed& missed) {
    return refined_fit(at, &slopes, std::move(breaks), degree, missed);
}

}  // namespace suture::concentric

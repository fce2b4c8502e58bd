#include "suture/fill/concentric/fit.h"

#include "suture/spline/knots.h"

#include <Eigen/Sparse>
#include <Eigen/SparseLU>

#include <algorithm>

namespace suture::concentric {
namespace {

using Eigen::MatrixXd;

constexpr int kMostSpans = 128;

/// Samples per span to measure the error at.
constexpr int kProbes = 3;

}  // namespace

std::vector<Break> sorted(std::vector<Break> breaks) {
    std::sort(breaks.begin(), breaks.end(), [](const Break& a, const Break& b) {
        return a.at < b.at || (a.at == b.at && !a.tangent && b.tangent);
    });
    breaks.erase(std::unique(breaks.begin(), breaks.end(),
                             [](const Break& a, const Break& b) { return a.at == b.at; }),
                 breaks.end());
    return breaks;
}

SplineCurve interpolated(const std::function<Eigen::VectorXd(double)>& at,
                         const std::vector<Break>& breaks, int degree, int spans) {
    const double from = breaks.front().at;
    const double to = breaks.back().at;
    SplineCurve curve{degree, std::vector<double>(static_cast<std::size_t>(degree + 1), from), {}};
    for (std::size_t i = 1; i < breaks.size(); ++i) {
        const double length = breaks[i].at - breaks[i - 1].at;
        for (int k = 1; k < spans; ++k) {
            curve.knots.push_back(breaks[i - 1].at + length * k / spans);
        }
        const bool last = i + 1 == breaks.size();
        const int times = last ? degree + 1 : (breaks[i].tangent ? degree - 1 : degree);
        curve.knots.insert(curve.knots.end(), static_cast<std::size_t>(times), breaks[i].at);
    }
    const auto n = static_cast<int>(curve.knots.size()) - degree - 1;
    curve.poles.resize(at(from).size(), n);
    const std::vector<double> nodes = greville(curve);
    std::vector<Eigen::Triplet<double>> entries;
    MatrixXd values(n, curve.poles.rows());
    for (int i = 0; i < n; ++i) {
        const double t = nodes[static_cast<std::size_t>(i)];
        const int span = find_span(curve.knots, degree, t);
        const MatrixXd basis = basis_derivatives(curve.knots, degree, span, t, 0);
        for (int k = 0; k <= degree; ++k) {
            entries.emplace_back(i, span - degree + k, basis(0, k));
        }
        values.row(i) = at(t).transpose();
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

FittedCurve fit_curve(const std::function<Eigen::VectorXd(double)>& at,
                      const std::vector<Break>& breaks, int degree, double accuracy) {
    FittedCurve best;
    for (int spans = 1; spans <= kMostSpans; spans *= 2) {
        FittedCurve fit{interpolated(at, breaks, degree, spans), 0.0};
        for (std::size_t i = 1; i < breaks.size(); ++i) {
            const double step = (breaks[i].at - breaks[i - 1].at) / (kProbes * spans);
            for (int k = 0; k < kProbes * spans; ++k) {
                // Off-centre: the error of an interpolant can vanish in the middle by symmetry.
                const double t = breaks[i - 1].at + (k + 0.4) * step;
                fit.error = std::max(fit.error, (evaluate(fit.curve, t).col(0) - at(t)).norm());
            }
        }
        if (spans == 1 || fit.error < best.error) {
            best = std::move(fit);
        }
        if (best.error <= accuracy) {
            break;
        }
    }
    return best;
}

}  // namespace suture::concentric

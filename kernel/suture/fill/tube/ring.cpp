#include "suture/fill/tube/ring.h"

#include "suture/base/contract.h"
#include "suture/spline/knots.h"

#include <array>
#include <numeric>

namespace suture::tube {
namespace {

/// Gauss-Legendre on [0,1] with four points: exact up to degree 7, and squares of cubics have 6.
constexpr std::array kNodes = {0.069431844202973712, 0.33000947820757187, 0.66999052179242813,
                               0.93056815579702629};
constexpr std::array kWeights = {0.17392742256872693, 0.32607257743127307, 0.32607257743127307,
                                 0.17392742256872693};

}  // namespace

Ring::Ring(std::vector<double> intervals) : intervals_(std::move(intervals)) {
    const int m = columns();
    SUTURE_EXPECTS(m >= 3);
    double knot = -interval(-1) - interval(-2);
    for (int k = -2; k <= m + 2; ++k) {
        // Sums from the start on, so that the first knot of the domain is 0 exactly.
        knots_.push_back(k == 0 ? 0.0 : knot);
        knot = knots_.back() + interval(k);
    }
    for (int k = 0; k < m; ++k) {
        if (interval(k) == 0.0) {
            const double before = interval(k - 1);
            const double after = interval(k + 1);
            SUTURE_EXPECTS(before > 0.0 && after > 0.0);
            doubles_.push_back({wrapped(k + 1), after / (before + after)});
        }
    }
}

Ring::Local Ring::on(int interval, double v, int orders) const {
    return {interval, basis_derivatives(knots_, 2, interval + 2, v, orders)};
}

Ring::Local Ring::at(double v, int orders) const {
    return on(find_span(knots_, 2, v) - 2, v, orders);
}

RealSparse Ring::gram(int b) const {
    std::vector<Eigen::Triplet<Real>> entries;
    for (int k = 0; k < columns(); ++k) {
        const double g = interval(k);
        for (std::size_t q = 0; q < kNodes.size() && g > 0.0; ++q) {
            const Local local = on(k, start(k) + g * kNodes[q], b);
            for (int r = 0; r < 3; ++r) {
                for (int c = 0; c < 3; ++c) {
                    entries.emplace_back(
                        wrapped(k + r), wrapped(k + c),
                        Real(kWeights[q] * g) * local.basis(b, r) * local.basis(b, c));
                }
            }
        }
    }
    RealSparse gram(columns(), columns());
    gram.setFromTriplets(entries.begin(), entries.end());
    return gram;
}

RealMatrix cubic_gram(const std::vector<double>& knots, int a) {
    constexpr int kDegree = 3;
    const int rows = static_cast<int>(knots.size()) - kDegree - 1;
    RealMatrix gram = RealMatrix::Zero(rows, rows);
    for (int span = kDegree; span < rows; ++span) {
        const double low = knots[static_cast<std::size_t>(span)];
        const double h = knots[static_cast<std::size_t>(span) + 1] - low;
        for (std::size_t q = 0; q < kNodes.size() && h > 0.0; ++q) {
            const Eigen::Matrix<Real, Eigen::Dynamic, 1> b =
                basis_derivatives(knots, kDegree, span, low + h * kNodes[q], a)
                    .row(a)
                    .transpose()
                    .cast<Real>();
            gram.block(span - kDegree, span - kDegree, kDegree + 1, kDegree + 1) +=
                Real(kWeights[q] * h) * b * b.transpose();
        }
    }
    return gram;
}

}  // namespace suture::tube
